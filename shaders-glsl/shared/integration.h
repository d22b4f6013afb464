// Methods of integrating light through a segment, and what the tables behind some of them are made of.
#ifndef TETRALUX_SHARED_INTEGRATION_H
#define TETRALUX_SHARED_INTEGRATION_H

#include "types.h"

SHARED_BEGIN

// Values of SPEC_INTEGRATION. Each is described in include/integration/.
SHARED_CONST uint INTEGRATION_EXACT = 0;
SHARED_CONST uint INTEGRATION_MOMENTS = 1;
SHARED_CONST uint INTEGRATION_LINEAR = 2;
SHARED_CONST uint INTEGRATION_PPI = 3;
SHARED_CONST uint INTEGRATION_AVERAGE = 4;
SHARED_CONST uint INTEGRATION_VERTEX = 5;
SHARED_CONST uint INTEGRATION_OPACITY2D = 6;
SHARED_CONST uint INTEGRATION_PREINT2D = 7;
SHARED_CONST uint INTEGRATION_PREINT3D = 8;
SHARED_CONST uint INTEGRATION_PREINT3D_LOG = 9;
SHARED_CONST uint INTEGRATION_PREINT3D_OCTAVE = 10;

// Values of SPEC_INTERPOLATION.
SHARED_CONST uint INTERPOLATION_PERSPECTIVE = 0;
SHARED_CONST uint INTERPOLATION_SCREEN = 1;

// Values of SPEC_PART_ACCURACY: largest error of a part's opacity, and of V, both relative to the opacity (include/integration/exact.glsl).
SHARED_CONST uint PART_FULL = 0;    // 1e-7, 3.2e-6
SHARED_CONST uint PART_FINE = 1;    // 3.8e-6, 1.3e-4
SHARED_CONST uint PART_MEDIUM = 2;  // 5.5e-5, 9.9e-4
SHARED_CONST uint PART_COARSE = 3;  // 1.2e-3, 1.6e-2

// Values of SPEC_TABLE_FORMAT: how an entry's numbers are stored.
SHARED_CONST uint TABLE_UNORM8 = 0;
SHARED_CONST uint TABLE_UNORM16 = 1;
SHARED_CONST uint TABLE_F16 = 2;
SHARED_CONST uint TABLE_F32 = 3;

// Texels of scales before the moments of pairs of pieces:
//   x a thickness, mesh units, y the largest extinction, 1/mesh unit, z and w what light and opacity are multiplied by
SHARED_CONST uint INTEGRATION_HEAD_TEXELS = 1;

// Parameters of the shaders in tables/.
struct TableParameters {
  uint width;
  uint height;
  uint depth;
  float thickness;        // mesh units: the largest, or the one that the table is made for
  float largestExtinction;  // 1/mesh unit
  float lightPerValue;    // entries are divided by these
  float opacityPerValue;
};

SHARED_END

#endif
