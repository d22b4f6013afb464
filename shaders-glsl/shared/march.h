// The march (march/): rays walking through the mesh's adjacency.
#ifndef TETRALUX_SHARED_MARCH_H
#define TETRALUX_SHARED_MARCH_H

#include "types.h"

SHARED_BEGIN

// Side of the square of pixels that a workgroup works on.
SHARED_CONST uint MARCH_TILE = 8;

// Invocations of a workgroup of the march's passes.
SHARED_CONST uint MARCH_WORKGROUP = 64;

// Rounds of a ray in one dispatch; what is left is done by another. Mesa's software device ends every loop after 65535 rounds,
// silently, and other devices stop work that takes seconds.
SHARED_CONST uint MARCH_ROUNDS = 16384;
// Cells instead, where a method looks for the pieces of the transfer function at a cell's two ends: those searches are loops, too, of
// up to twenty rounds, and may count against the same limit.
SHARED_CONST uint MARCH_CELLS = 1536;
SHARED_CONST uint MARCH_LAST_ROUND = 65000;  // for the parts of the last cell, which is not left half done

// Rounds of a turn on devices that skip branches which no ray of a subgroup takes: after it, rays that have left the mesh come back
// in. Processors pay for those branches every time; there a turn ends with the last ray's walk.
SHARED_CONST uint MARCH_TURN_ROUNDS = 8;

// Invocations that share a job there: each would have up to 64 pixels for itself. On processors jobs are too small for more than one.
SHARED_CONST uint MARCH_JOB_LANES = 8;

// Pixels of a band: the tiles that one face may cover stay far below the 65535 rounds of a loop.
SHARED_CONST uint MARCH_BAND_PIXELS = 1u << 20;

// A job is a face and those pixels of a tile that its rectangle covers: the tile's index, then the first and last column and row
// in it, three bits each. Nodes of lists are set aside for as many entries as it has pixels.
SHARED_CONST uint MARCH_JOB_PLACE_BITS = 12;

// A band's numbers of workgroups (VkDispatchIndirectCommand), and of what there was to do.
struct MarchCounts {
  uint jobGroups, jobGroupsY, jobGroupsZ;
  uint walkTiles, walkTilesY, walkTilesZ;  // tiles with jobs
  uint sortTiles, sortTilesY, sortTilesZ;  // tiles with a pixel that has more than one face
  uint jobs;        // wanted; there may be room for fewer
  uint nodes;       // of the pixels' lists, set aside for jobs, likewise
  uint unfinished;  // rays that are not through
  // With SPEC_COUNT_WORK; the rest is of 64 bits each:
  uint entries;  // nodes that are used
  uint cellsLow, cellsHigh;  // steps from cell to cell
  uint partsLow, partsHigh;  // segments, or parts of segments, that were integrated
};

SHARED_END

#endif
