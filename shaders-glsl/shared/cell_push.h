// What the shaders that draw cells know about camera, image and batch.
#ifndef TETRALUX_SHARED_CELL_PUSH_H
#define TETRALUX_SHARED_CELL_PUSH_H

#include "pixel_lists.h"
#include "types.h"

SHARED_BEGIN

struct ScreenScale {
  vec2 halfSize;        // half the image's width and height, pixels
  float unitsPerPixel;  // x/z (perspective) or x (orthographic) per pixel
};

struct CellPush {
  ScreenScale scale;
  PixelBand band;  // of the lists; only apart/
  uint firstSlot;  // of the batch
};

SHARED_END

#endif
