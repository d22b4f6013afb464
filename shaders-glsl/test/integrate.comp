// For tests: the integral of single segments, by the code that the raster pass runs.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#define TRANSFER_PIECES 0
#define TRANSFER_PIECE_BINS 1
#define INTEGRATION_NUMBERS 2
#define INTEGRATION_TABLE_2D 3
#define INTEGRATION_TABLE_3D 4
#include "include/dispatch.glsl"
#include "include/integrate.glsl"

layout(binding = 5, scalar) readonly buffer Segments { vec4 segments[]; };  // x front, y back, z thickness
layout(binding = 6, scalar) writeonly buffer Results { vec4 results[]; };

layout(push_constant, scalar) uniform Push { uint segmentCount; };

void main() {
  const uint i = linearIndex();
  if (i < segmentCount) results[i] = integrateSegment(segments[i].x, segments[i].y, segments[i].z);
}
