// What the passes of a frame know about camera and image.
//
// Mesh space: (world - centre) / scale, the mesh within [-1, 1]. View space: mesh space turned and moved so that the
// eye is the origin, x right, y up, z forward. Screen: pixels from the image's centre, x right, y up.
#ifndef TETRALUX_SHARED_FRAME_VIEW_H
#define TETRALUX_SHARED_FRAME_VIEW_H

#include "types.h"

SHARED_BEGIN

struct FrameView {
  vec4 viewFromMesh[3];  // row i: xyz the rotation's row, w the translation
  vec4 viewFromMeshRest[3];  // what single precision leaves of it
  vec4 eyeMesh;          // xyz: eye in mesh space; w: its length
  vec2 halfSize;         // half the image's width and height, pixels
  float pixelsPerUnit;   // pixels per unit of x/z (perspective) or x (orthographic)
  float pixelsPerUnitRest;
  uint keyBits;          // bits of the sort key, <= 24
  float keyLow;          // distance that gets the nearest key, relative to |eye| under perspective, mesh units
  float keyPerDistance;  // 1 / (distance of the farthest key - keyLow)
  uint cellCount;
  uint supportCount;     // intervals of scalars with extinction or emission
};

SHARED_END

#endif
