// The visibility order by peeling (order/).
#ifndef TETRALUX_SHARED_VISIBILITY_H
#define TETRALUX_SHARED_VISIBILITY_H

#include "types.h"

SHARED_BEGIN

// State of a cell while it waits for the cells behind it.
SHARED_CONST uint WAIT_COUNT = 0x00ffffffu;   // how many of them are left
SHARED_CONST uint WAIT_FRONT_SHIFT = 24;      // 4 bits: faces whose other cell lies in front
SHARED_CONST uint WAIT_PEELED = 0x10000000u;  // it has a level
SHARED_CONST uint WAIT_RELATED = 0x20000000u;  // cells across a gap wait for it
SHARED_CONST uint WAIT_ABSENT = 0xffffffffu;  // it takes no part: outside the picture, or without a pixel's centre

// Marks where a ray enters the mesh, beside the bits of a depth that is not negative.
SHARED_CONST uint ENTRY_BIT = 0x80000000u;

struct PeelStatus {
  uint present;    // cells that take part
  uint begin;      // of the current level in the queue
  uint end;        // of the queue
  uint level;      // number of levels so far
  uint relations;  // pairs of cells across gaps that there was room for, and those that there was not
  uint eyeInside;  // 1: the eye is inside a cell
};

// A cell across a gap in front of another one, in that one's list.
struct Relation {
  uint cell;
  uint next;
};

// What order/check.comp and order/relate.comp count.
struct OrderCount {
  uint faces;                // shared faces that a ray may pass through
  uint misordered;           // ... whose two cells are drawn the wrong way round
  uint relations;            // pairs of cells behind each other across a gap, at a pixel
  uint misorderedRelations;  // ... drawn the wrong way round
  uint eyeInside;            // 1: the eye is inside a cell
};

SHARED_END

#endif
