// Lists of fragments, one for every pixel of a band of rows.
#ifndef TETRALUX_SHARED_PIXEL_LISTS_H
#define TETRALUX_SHARED_PIXEL_LISTS_H

#include "types.h"

SHARED_BEGIN

// End of a list; a pixel without fragments.
SHARED_CONST uint NO_NODE = 0xffffffffu;

SHARED_CONST uint KBUFFER_LARGEST = 16;

// The band that a pass works on.
struct PixelBand {
  uint width;     // of the image, pixels
  uint firstRow;  // from the top
  uint rowCount;
  uint index;     // of the band: where its nodes are counted
  uint capacity;  // nodes that there is room for
};

SHARED_END

#endif
