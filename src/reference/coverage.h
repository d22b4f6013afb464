// Which pixels show anything.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "reference/ray_caster.h"

namespace tetralux::reference {

// One flag per pixel, row by row from the top: 1 where the picture is not empty (a channel that is not zero, or not a
// number) or the exact answer may not be: the pixel's ray meets an opaque surface, or passes through a cell whose
// volume may show, or crosses an isosurface, where clip planes keep it. Boxes of cells are compared with the picture
// first, so that a picture that is right costs little more than one look at each cell.
//   picture   of scene.size
std::vector<std::uint8_t> coveredPixels(const ReferenceScene& scene, const Image& picture);

}  // namespace tetralux::reference
