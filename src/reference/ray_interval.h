// The part of a ray that clip planes and opaque surfaces leave.
#pragma once

#include <limits>
#include <vector>

#include "reference/cell_ray.h"
#include "volume/appearance.h"

namespace tetralux::reference {

// Depths along a ray; empty when low >= high.
struct DepthRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

// The part of a ray, and of its extension behind the origin, that all planes keep. A ray that lies in a plane, up to
// rounding, is kept by it.
DepthRange keptRange(const std::vector<ClipPlane>& planes, const Ray& ray);

// Cuts a chord to a range; scalars and weights are interpolated. An end of the range that differs only by rounding from
// one of the chord's is that end: so a plane in a cell's face cuts off all or nothing. False when nothing is left.
bool cutChord(CellChord& chord, const DepthRange& range);

}  // namespace tetralux::reference
