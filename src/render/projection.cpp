#include "render/projection.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.h"

namespace tetralux::render {

const std::vector<std::string>& projectionNames() {
  static const std::vector<std::string> names = {"pt", "silhouette", "gator", "march", "auto"};
  return names;
}

const char* projectionName(CellProjection projection) {
  return projectionNames()[static_cast<size_t>(projection)].c_str();
}

CellProjection parseProjection(const std::string& name) {
  const auto& names = projectionNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    fail(ErrorCode::Usage, "--projection: found '{}', expected one of {}", name, fmt::join(names, ", "));
  return static_cast<CellProjection>(found - names.begin());
}

ProjectionChoice chooseProjection(bool isWalkable) {
  // Measured on Mesa's software device, exact integration, frames of five meshes: nanoseconds per cell that a ray hits.
  // On NVIDIA's H200 the share is 0.02 to 0.1 (docs/benchmarks.md).
  constexpr double kDrawnNs = 40.0;
  constexpr double kWalkedNs = 8.0;
  // Frames took 0.60 to 0.95 of the time with outlines (eight scenes on Mesa's software device), 0.57 to 0.97 (H200).
  constexpr double kOutlinedShare = 0.75;
  if (isWalkable)
    return {CellProjection::March, "a cell costs less to walk through than to draw", kWalkedNs / kDrawnNs};
  return {CellProjection::Silhouette,
          "cells are to be blended: an outline costs less than a fan, and nothing is interpolated over the screen",
          kOutlinedShare};
}

}  // namespace tetralux::render
