// One more slice of a table of pre-integrated segments from the slices before it (Weiler, Kraus, Merz and Ertl 2003, incremental
// pre-integration; Kraus, Qiao and Ebert 2004, section 3, for the logarithmic axis): a segment is cut in two, and both parts are
// looked up. On the logarithmic axis slice k + 1 is twice as thick as slice k, and both parts are halves; on the linear one, the
// part in front is a slice 1 thick.
//
// Where the cut falls between two entries, they are interpolated linearly in the scalar: that is the error of this way.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/integration.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

layout(binding = 0, scalar) writeonly buffer Entries { vec4 entries[]; };
layout(binding = 1) uniform samplerBuffer entriesBefore;  // the same memory

layout(constant_id = SPEC_INTEGRATION) const uint kIntegration = INTEGRATION_PREINT3D;
layout(constant_id = SPEC_EMISSION_PER_LENGTH) const bool kEmissionPerLength = false;

layout(push_constant, scalar) uniform Push {
  TableParameters table;
  uint slice;  // that is made, at least 2
};

#include "include/dispatch.glsl"

vec4 entry(uint x, uint y, uint z) {
  return texelFetch(entriesBefore, int((z * table.height + y) * table.width + x));
}

// Between entries along the front's axis, or along the back's.
vec4 atFront(float x, uint y, uint z) {
  const uint low = min(uint(x), table.width - 2u);
  return mix(entry(low, y, z), entry(low + 1u, y, z), x - float(low));
}

vec4 atBack(uint x, float y, uint z) {
  const uint low = min(uint(y), table.height - 2u);
  return mix(entry(x, low, z), entry(x, low + 1u, z), y - float(low));
}

void main() {
  const uint index = linearIndex();
  if (index >= table.width * table.height) return;
  const uint x = index % table.width;
  const uint y = index / table.width;
  const bool isLinear = kIntegration == INTEGRATION_PREINT3D;
  const float share = isLinear ? 1.0 / float(slice) : 0.5;  // of the part in front
  // The scalar at the cut, as a place on the axes of the back and of the front.
  const vec2 last = vec2(table.width - 1u, table.height - 1u);
  const float cut = mix(float(x) / last.x, float(y) / last.y, share);
  const vec4 front = atBack(x, cut * last.y, isLinear ? 1u : slice - 1u);
  const vec4 back = atFront(cut * last.x, y, slice - 1u);
  const float opacity = front.a + (1.0 - front.a) * back.a;
  // With emission per length entries hold light per length.
  const vec3 light = kEmissionPerLength ? share * front.rgb + (1.0 - share) * (1.0 - front.a) * back.rgb
                                        : front.rgb + (1.0 - front.a) * back.rgb;
  entries[slice * table.width * table.height + index] = vec4(light, opacity);
}
