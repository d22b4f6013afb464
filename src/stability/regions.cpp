#include "stability/region.h"

namespace tetralux::stability {

const std::vector<Region>& regions() {
  static const std::vector<Region> all = [] {
    std::vector<Region> list;
    for (auto part : {segmentRegions, scalarRegions, shapeRegions, placeRegions, viewRegions}) {
      for (Region& region : part()) list.push_back(std::move(region));
    }
    return list;
  }();
  return all;
}

}  // namespace tetralux::stability
