// Where a segment crosses isosurfaces.
#pragma once

#include <vector>

#include "volume/appearance.h"

namespace tetralux::reference {

struct Crossing {
  double share = 0.0;  // of the segment that lies in front, 0 to 1
  const Isosurface* surface = nullptr;
  bool isRising = false;  // of the scalar along the ray
};

// Crossings in the order of the ray: of the surfaces of whose value exactly one of the two scalars is not below.
//   surfaces   ascending; the result refers to them
std::vector<Crossing> isosurfaceCrossings(const std::vector<Isosurface>& surfaces, double sFront, double sBack);

}  // namespace tetralux::reference
