// The same as store.frag, of cells that raster/gator.vert projects.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/clipped_cells.h"
#include "shared/cell_push.h"
#include "shared/spec_ids.h"

#define CELL_PLANES_FLAT
#define TRANSFER_PIECES 7
#define TRANSFER_PIECE_BINS 8
#define INTEGRATION_NUMBERS 9
#define INTEGRATION_TABLE_2D 10
#define INTEGRATION_TABLE_3D 11
#include "include/fan_segment.glsl"
layout(push_constant, scalar) uniform Push { CellPush push; };

#define PIXEL_HEADS 12
#define PIXEL_LINKS 13
#define PIXEL_RANKS 14
#define PIXEL_COLORS 15
#define PIXEL_COUNTS 16
#include "include/store_segment.glsl"
