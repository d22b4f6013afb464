// The same as fan.frag, of cells that raster/gator.vert projects.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/clipped_cells.h"
#include "shared/cell_push.h"
#include "shared/spec_ids.h"
#include "shared/target_output.h"

#define CELL_PLANES_FLAT
#define TRANSFER_PIECES 7
#define TRANSFER_PIECE_BINS 8
#define INTEGRATION_NUMBERS 9
#define INTEGRATION_TABLE_2D 10
#define INTEGRATION_TABLE_3D 11
#include "include/fan_segment.glsl"
#include "include/target_output.glsl"

layout(push_constant, scalar) uniform Push { CellPush push; };

layout(location = 0) out vec4 color;  // premultiplied light, opacity; or what kOutput says

void main() {
  if (kOutput == OUTPUT_CONSTANT) {
    color = vec4(1.0 / 1024.0);
    return;
  }
  const vec2 screen = screenOf(gl_FragCoord, push.scale);
  const vec4 layer = fragmentColor(fragmentSegment(screen), screen);
  color = targetOutput(layer, uvec2(gl_FragCoord.xy), uint(fanSlot()));
}
