// Segments of fans into lists (include/store_segment.glsl).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/clipped_cells.h"
#include "shared/cell_push.h"
#include "shared/spec_ids.h"

#define CELL_PLANES 1
#define TRANSFER_PIECES 2
#define TRANSFER_PIECE_BINS 3
#define INTEGRATION_NUMBERS 4
#define INTEGRATION_TABLE_2D 5
#define INTEGRATION_TABLE_3D 6
#include "include/fan_segment.glsl"
layout(push_constant, scalar) uniform Push { CellPush push; };

#define PIXEL_HEADS 7
#define PIXEL_LINKS 8
#define PIXEL_RANKS 9
#define PIXEL_COLORS 10
#define PIXEL_COUNTS 11
#include "include/store_segment.glsl"
