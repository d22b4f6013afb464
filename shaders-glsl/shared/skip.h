// Empty-space skipping (skip/).
#ifndef TETRALUX_SHARED_SKIP_H
#define TETRALUX_SHARED_SKIP_H

#include "types.h"

SHARED_BEGIN

// Invocations of a workgroup of the pass.
SHARED_CONST uint SKIP_WORKGROUP = 64;

struct SkipCounts {
  uint cells;  // that are kept
  uint faces;  // of theirs, behind which no cell is kept
};

SHARED_END

#endif
