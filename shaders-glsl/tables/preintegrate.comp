// The tables behind include/integration/preintegration.glsl: a segment for every front scalar, back scalar and thickness, integrated
// exactly (include/integration/exact.glsl) rather than step by step, so that a table has no error but its resolution's.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/integration.h"
#include "shared/limits.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#define TABLE_WORDS 0
#define TRANSFER_PIECES 1
#define TRANSFER_PIECE_BINS 2
#include "include/dispatch.glsl"
#include "include/table_store.glsl"
#include "include/integration/exact.glsl"

layout(constant_id = SPEC_INTEGRATION) const uint kIntegration = INTEGRATION_PREINT3D;

layout(push_constant, scalar) uniform Push { TableParameters table; };

// Share of the largest thickness that a slice stands for.
float sliceShare(uint slice) {
  if (table.depth == 1u) return 1.0;
  const float last = float(table.depth - 1u);
  if (kIntegration == INTEGRATION_PREINT3D) return float(slice) / last;
  return slice == 0u ? 0.0 : exp2(float(slice) - last);
}

void main() {
  const uint index = linearIndex();
  const uint slice = index / (table.width * table.height);
  if (slice >= table.depth) return;
  const uint inSlice = index % (table.width * table.height);
  const float front = float(inSlice % table.width) / float(table.width - 1u) - 0.5;
  const float back = float(inSlice / table.width) / float(table.height - 1u) - 0.5;
  const float thickness = table.thickness * sliceShare(slice);
  vec4 value;
  if (kEmissionPerLength) {
    // Light per length (include/integration/preintegration.glsl); that of no thickness at all is that of so thin a segment that nothing
    // is absorbed.
    const float thin = 1e-9 * table.thickness / max(1.0, table.largestExtinction * table.thickness);
    const float length = max(thickness, thin);
    value = integrateExact(front, back, length);
    value = vec4(value.rgb / length, thickness > 0.0 ? value.a : 0.0);
  } else {
    value = integrateExact(front, back, thickness);
  }
  storeFour(index, value / vec4(vec3(table.lightPerValue), table.opacityPerValue));
}
