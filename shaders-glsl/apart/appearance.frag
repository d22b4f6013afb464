// Segments of cells into lists (include/store_segment.glsl), with all that is shown beside the volume.
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
#include "shared/visibility.h"

#include "include/cell_segment.glsl"

#define PIXEL_HEADS 15
#define PIXEL_LINKS 16
#define PIXEL_RANKS 17
#define PIXEL_COLORS 18
#define PIXEL_COUNTS 19
#include "include/store_segment.glsl"
