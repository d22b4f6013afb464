// What the walks of march.glsl and march_appearance.glsl read and write. With METHODS, segments are integrated by the method that
// the pipeline is specialised for; without, exactly: lavapipe takes twice as long for a module that has them all.
#include "shared/clipped_cells.h"
#include "shared/frame_view.h"
#include "shared/limits.h"
#include "shared/march.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"
#include "shared/visibility.h"

layout(local_size_x = MARCH_WORKGROUP) in;

// Rounds that a ray which has left the mesh waits at most for others of its subgroup before it comes back in.
layout(constant_id = SPEC_TURN_ROUNDS) const uint kTurnRounds = MARCH_LAST_ROUND;

#define MESH_CELLS 1
#define MESH_VERTICES 2
#define MESH_CELL_SCALARS 3
#define TOPOLOGY_ACROSS 4
#define TRANSFER_PIECES 5
#define TRANSFER_PIECE_BINS 6
#define TRANSFER_POINTS 12
#define TRANSFER_POINT_SCALARS 13
#define MARCH_TILES 14
#define MESH_VERTEX_RESTS 15
#if defined METHODS
#define INTEGRATION_NUMBERS 16
#define INTEGRATION_TABLE_2D 17
#define INTEGRATION_TABLE_3D 18
#elif defined APPEARANCE
#define APPEARANCE_TEXELS 16
#define VERTEX_GRADIENTS 17
#define RAY_ENDS 18
#define VERTEX_NUMBERS 19
#define VERTEX_COLORS 20
layout(constant_id = SPEC_ISOSURFACES) const bool kIsosurfaces = false;
layout(constant_id = SPEC_VOLUME) const bool kVolume = true;
#endif
#include "include/dispatch.glsl"
#include "include/integrate.glsl"
#ifndef METHODS
const uint kIntegration = INTEGRATION_EXACT;
#endif
#include "include/integration/ray_parts.glsl"
#include "include/march/count_work.glsl"
#include "include/march_pixel.glsl"
#include "include/mesh_access.glsl"
#include "include/real.glsl"
#include "include/view_space.glsl"
#include "include/ray_walk.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
#define PIXEL_HEADS 7
#define PIXEL_LINKS 8
#define PIXEL_RANKS 9
#include "include/pixel_lists.glsl"
layout(binding = 10, scalar) buffer Colors { vec4 colors[]; };
layout(binding = 11, scalar) buffer Counts { MarchCounts counts; };

layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  VertexRestsAt restsAt;
  AcrossAt acrossAt;
  PixelBand band;
};
