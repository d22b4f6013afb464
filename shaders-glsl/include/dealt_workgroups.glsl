// Which workgroup does which part of the work.
//
// Mesa's software device gives each of its threads an equal run of a dispatch's workgroups, whatever they cost, and the slowest half of a
// picture decides. So short runs of parts are dealt out to them in turn: each gets a like share of all that is cheap or dear, and still
// goes from neighbour to neighbour, as its caches want.
//
// Before including: dispatch.glsl.
#include "shared/spec_ids.h"

layout(constant_id = SPEC_DISPATCH_THREADS) const uint kDispatchThreads = 1;

const uint kDealtRun = 4;  // workgroups

uint dealtWorkgroupIndex() {
  const uint index = workgroupIndex();
  if (kDispatchThreads == 1u) return index;
  const uint rounds = gl_NumWorkGroups.x * gl_NumWorkGroups.y / (kDealtRun * kDispatchThreads);
  const uint run = index / kDealtRun;
  if (run >= rounds * kDispatchThreads) return index;  // what is left over
  return (run % rounds * kDispatchThreads + run / rounds) * kDealtRun + index % kDealtRun;
}

// The same for invocations, as linearIndex().
uint dealtIndex() { return dealtWorkgroupIndex() * gl_WorkGroupSize.x + gl_LocalInvocationIndex; }
