#include "reference/isosurface_crossings.h"

#include <algorithm>

namespace tetralux::reference {

std::vector<Crossing> isosurfaceCrossings(const std::vector<Isosurface>& surfaces, double sFront, double sBack) {
  std::vector<Crossing> crossings;
  for (const Isosurface& surface : surfaces) {
    const bool isRising = sFront < surface.value;
    if (isRising == (sBack < surface.value)) continue;
    crossings.push_back({(surface.value - sFront) / (sBack - sFront), &surface, isRising});
  }
  if (sBack < sFront) std::reverse(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace tetralux::reference
