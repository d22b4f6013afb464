// What is shown beside the volume (docs/appearance.md), as the march knows it: a list of texels, vec4 each, in this order.
//
//   clip planes   xyz normal in view space, w its product with the eye's place less the offset: kept where
//                 w + dot(normal, place from the eye) >= 0, mesh units; APPEARANCE_CLIP_TEXELS each
//   material      ambient, diffuse, specular, shininess
//   lights        xyz towards the light, mesh space; then rgb; APPEARANCE_LIGHT_TEXELS each
//   isosurfaces   rgb, opacity; rgb of the back, shading (SHADING_*); APPEARANCE_SURFACE_TEXELS each
//   curves        of factors, in the order of ModulatedBy: per point x its value, normalised like the number at vertices; then the factors of
//                 luminance and extinction; APPEARANCE_CURVE_TEXELS each
//   2-D transfer  x scalars, normalised; x gradients' lengths, normalised; luminance, extinction (1/mesh unit), rows of scalars
#ifndef TETRALUX_SHARED_APPEARANCE_H
#define TETRALUX_SHARED_APPEARANCE_H

#include "types.h"

SHARED_BEGIN

SHARED_CONST uint APPEARANCE_CLIP_TEXELS = 1;
SHARED_CONST uint APPEARANCE_LIGHT_TEXELS = 2;
SHARED_CONST uint APPEARANCE_SURFACE_TEXELS = 2;
SHARED_CONST uint APPEARANCE_CURVE_TEXELS = 2;

// Of pixels whose rays meet no opaque surface: their triangle, and the depth of what ends the ray.
SHARED_CONST uint NO_TRIANGLE = 0xffffffffu;
SHARED_CONST float NO_RAY_END = 1e30f;

// As in volume/lighting.h.
SHARED_CONST uint SHADING_NONE = 0;
SHARED_CONST uint SHADING_FLAT = 1;
SHARED_CONST uint SHADING_PHONG = 2;

SHARED_END

#endif
