// What the raster pass's fragment shader knows about camera and image.
#ifndef TETRALUX_SHARED_RASTER_PUSH_H
#define TETRALUX_SHARED_RASTER_PUSH_H

#include "types.h"

SHARED_BEGIN

struct RasterPush {
  vec2 halfSize;        // half the image's width and height, pixels
  float unitsPerPixel;  // x/z (perspective) or x (orthographic) per pixel
};

SHARED_END

#endif
