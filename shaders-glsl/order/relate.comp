// Relations across gaps: where a ray leaves the mesh and enters it again, the cell that it leaves is in front of the cell that
// it enters (Williams 1992; Cook, Max, Silva and Williams 2004, SXMPVO, by scan conversion).
//
// One invocation per pixel of a band. Exits and entries are each sorted by depth, and the k-th exit is followed by the next
// entry by count, not by depth: on a seam, where both are at the same place up to rounding, their order is still right. A
// ray that starts inside the mesh has one exit more than entries. Where the numbers do not fit, as at silhouettes where a
// sliver of the boundary was given to the wrong side, the pixel says nothing.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"
#include "shared/visibility.h"

layout(local_size_x = 64) in;

layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;
layout(constant_id = SPEC_RELATE_CHECK) const bool kCheck = false;

#include "include/dispatch.glsl"
#define PIXEL_HEADS 0
#define PIXEL_LINKS 1
#define PIXEL_RANKS 2
#include "include/pixel_lists.glsl"

layout(binding = 3, scalar) coherent buffer Waiting { uint waiting[]; };             // not when checking
layout(binding = 4, scalar) coherent buffer RelationHeads { uint relationHeads[]; };  // ...
layout(binding = 5, scalar) coherent buffer Relations { Relation relations[]; };      // ...
layout(binding = 6, scalar) buffer Status { PeelStatus status; };                     // ...
layout(binding = 7) uniform usamplerBuffer keys;                                      // when checking
layout(binding = 8, scalar) buffer Count { OrderCount count; };                       // ...

layout(buffer_reference, scalar, buffer_reference_align = 4) coherent buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  UintsAt waitingAt;
  UintsAt relationHeadsAt;
  UintsAt keysAt;
  PixelBand band;
  uint relationCapacity;
  uint keyShift;      // lowest bit that the sort looks at
  uint tiesAreApart;  // cells of equal keys are composited apart, in the right order by themselves
};

#include "include/relations.glsl"

void checkRelation(uint front, uint behind) {
  const uint frontKey = kWideAddressing ? keysAt.data[front] : texelFetch(keys, int(front)).x;
  const uint behindKey = kWideAddressing ? keysAt.data[behind] : texelFetch(keys, int(behind)).x;
  const uint frontRank = (frontKey & ~KEY_TRANSPARENT) >> keyShift;
  const uint behindRank = (behindKey & ~KEY_TRANSPARENT) >> keyShift;
  const bool isWrong = frontRank < behindRank || (frontRank == behindRank && front < behind && tiesAreApart == 0u);
  atomicAdd(count.relations, 1u);
  if (isWrong) atomicAdd(count.misorderedRelations, 1u);
}

void main() {
  const uint pixel = linearIndex();
  if (pixel >= band.width * band.rowCount) return;
  if (pixelHeads[pixel] == NO_NODE) return;
  const uint head = sortedList(pixelHeads[pixel]);
  uint exits = 0;
  uint entries = 0;
  uint entry = head;
  for (uint i = 0; i < kLongestList; i++) {
    if (entry == NO_NODE || (pixelRanks[entry].x & ENTRY_BIT) != 0u) break;
    exits++;
    entry = pixelLinks[entry];
  }
  const uint firstEntry = entry;
  for (uint i = 0; i < kLongestList; i++) {
    if (entry == NO_NODE) break;
    entries++;
    entry = pixelLinks[entry];
  }
  if (exits == 0u || entries == 0u) return;

  const bool isEyeInside = (kCheck ? count.eyeInside : status.eyeInside) != 0u;
  const bool isExitFirst = pixelRanks[head].x < (pixelRanks[firstEntry].x & ~ENTRY_BIT);
  const bool startsInside = exits == entries + 1u && (isEyeInside || isExitFirst);
  if (!startsInside && (exits != entries || isEyeInside)) return;
  uint exit = head;
  entry = startsInside ? firstEntry : pixelLinks[firstEntry];
  for (uint i = 0; i < kLongestList; i++) {
    if (entry == NO_NODE || exit == firstEntry) break;
    const uint front = pixelRanks[exit].y;
    const uint behind = pixelRanks[entry].y;
    if (front != behind) {
      if (kCheck)
        checkRelation(front, behind);
      else
        addRelation(front, behind);
    }
    exit = pixelLinks[exit];
    entry = pixelLinks[entry];
  }
}
