// Radix sort, tiled variant, last step: every key of a tile to its place, order among equal digits kept.
//
// Each subgroup owns a run of the tile's keys and goes through it a subgroup's width at a time. Lanes with the same digit
// find each other by ballots over the digit's bits; their ranks follow lane order, so the sort is stable.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "shared/limits.h"
#include "shared/sort.h"
#include "shared/spec_ids.h"

layout(local_size_x = 256) in;

#define SORT_KEYS_IN 0
#include "include/dispatch.glsl"
#include "include/sort_keys.glsl"

layout(binding = 1) uniform usamplerBuffer valuesIn;
layout(binding = 2, scalar) readonly buffer Offsets { uint offsets[]; };  // [digit][tile]
layout(binding = 3, scalar) readonly buffer Bases { uint bases[]; };      // [digit]
layout(binding = 4, scalar) readonly buffer Kept { uint kept; };
layout(binding = 5, scalar) writeonly buffer KeysOut { uint keysOut[]; };
layout(binding = 6, scalar) writeonly buffer ValuesOut { uint valuesOut[]; };

layout(push_constant, scalar) uniform Push {
  UintsAt keysAt;
  UintsAt valuesAt;
  UintsAt keysOutAt;
  UintsAt valuesOutAt;
  uint cellCount;
  uint tileCount;
  uint shift;
};

shared uint counters[SORT_TILE_THREADS / SORT_TILE_LEAST_SUBGROUP * SORT_DIGITS];  // [subgroup][digit]

// Lanes of the subgroup that are active and have the same digit.
uvec4 lanesWithDigit(uint digit, bool isActive) {
  uvec4 same = subgroupBallot(isActive);
  for (uint bit = 0; bit < SORT_DIGIT_BITS; bit++) {
    const bool isSet = ((digit >> bit) & 1u) != 0u;
    const uvec4 set = subgroupBallot(isSet);
    same &= isSet ? set : ~set;
  }
  return same;
}

void main() {
  const uint tile = workgroupIndex();
  const uint count = elementCount(cellCount, kept);
  const uint run = SORT_TILE_KEYS / gl_NumSubgroups;
  const uint first = tile * SORT_TILE_KEYS + gl_SubgroupID * run;
  const uint myCounters = gl_SubgroupID * SORT_DIGITS;
  for (uint i = gl_LocalInvocationIndex; i < gl_NumSubgroups * SORT_DIGITS; i += gl_WorkGroupSize.x) counters[i] = 0u;
  barrier();

  uint key[SORT_TILE_KEYS_PER_THREAD];
  uint rank[SORT_TILE_KEYS_PER_THREAD];
  for (uint k = 0; k < SORT_TILE_KEYS_PER_THREAD; k++) {
    const uint i = first + k * gl_SubgroupSize + gl_SubgroupInvocationID;
    key[k] = i < count ? loadKey(keysAt, i) : KEY_OUTSIDE;
    const bool isActive = i < count && takesPart(key[k]);
    const uint digit = digitOf(key[k], shift);
    const uvec4 same = lanesWithDigit(digit, isActive);
    const uint before = subgroupBallotExclusiveBitCount(same);
    rank[k] = counters[myCounters + digit] + before;
    subgroupMemoryBarrierShared();
    subgroupBarrier();
    if (isActive && before == 0u) counters[myCounters + digit] += subgroupBallotBitCount(same);
    subgroupMemoryBarrierShared();
    subgroupBarrier();
    if (!isActive) rank[k] = ~0u;
  }
  barrier();

  // Counters become offsets: of the digit, of the tile in it, of the subgroup in the tile.
  for (uint digit = gl_LocalInvocationIndex; digit < SORT_DIGITS; digit += gl_WorkGroupSize.x) {
    uint sum = tile < tileCount ? bases[digit] + offsets[digit * tileCount + tile] : 0u;
    for (uint subgroup = 0; subgroup < gl_NumSubgroups; subgroup++) {
      const uint own = counters[subgroup * SORT_DIGITS + digit];
      counters[subgroup * SORT_DIGITS + digit] = sum;
      sum += own;
    }
  }
  barrier();

  for (uint k = 0; k < SORT_TILE_KEYS_PER_THREAD; k++) {
    if (rank[k] == ~0u) continue;
    const uint i = first + k * gl_SubgroupSize + gl_SubgroupInvocationID;
    const uint value = kFirstDigit ? i : kWideAddressing ? valuesAt.data[i] : texelFetch(valuesIn, int(i)).x;
    const uint place = counters[myCounters + digitOf(key[k], shift)] + rank[k];
    if (kWideAddressing) {
      keysOutAt.data[place] = key[k];
      valuesOutAt.data[place] = value;
    } else {
      keysOut[place] = key[k];
      valuesOut[place] = value;
    }
  }
}
