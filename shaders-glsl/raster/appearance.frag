// The same as fan.frag, with all that is shown beside the volume.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/clipped_cells.h"
#include "shared/cell_push.h"
#include "shared/frame_view.h"
#include "shared/integration.h"
#include "shared/spec_ids.h"
#include "shared/target_output.h"
#include "shared/visibility.h"

#include "include/cell_segment.glsl"
#include "include/target_output.glsl"

layout(location = 0) out vec4 color;  // premultiplied light, opacity; or what kOutput says

void main() {
  if (kOutput == OUTPUT_CONSTANT) {
    color = vec4(1.0 / 1024.0);
    return;
  }
  const vec4 layer = fragmentColor(fragmentSegment(gl_FragCoord.xy), gl_FragCoord.xy);
  color = targetOutput(layer, uvec2(gl_FragCoord.xy), uint(fanSlot()));
}
