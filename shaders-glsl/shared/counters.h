// What the passes of a frame count.
#ifndef TETRALUX_SHARED_COUNTERS_H
#define TETRALUX_SHARED_COUNTERS_H

#include "types.h"

SHARED_BEGIN

struct FrameCounters {
  uint outside;      // cells culled: behind the eye or beside the image
  uint noSample;     // cells culled: no pixel centre inside
  uint transparent;  // cells culled: neither extinction nor emission anywhere in their scalar range
  uint drawn;        // cells that the sort kept
  uint triangles;    // triangles with an area that their fans have
  uint clipped;      // cells drawn by clipping rays against their faces
  uint padding0;
  uint padding1;
};

SHARED_END

#endif
