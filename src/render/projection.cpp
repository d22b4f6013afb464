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

ProjectionChoice chooseProjection(bool isProcessor, bool isWalkable, std::optional<double> tolerance) {
  // Measured on Mesa's software device, exact integration, frames of five meshes: nanoseconds per cell that a ray hits.
  constexpr double kDrawnNs = 40.0;
  constexpr double kWalkedNs = 11.0;
  // Frames of eight scenes took 0.60 to 0.95 of the time with outlines.
  constexpr double kOutlinedShare = 0.75;
  // By snapping vertices to 1/256 pixel, rasterisers may change what an edge-on cell that is not clipped adds by so
  // much (shared/clipped_cells.h).
  constexpr double kFanError = 1.0 / 362.0;
  if (isProcessor && isWalkable)
    return {CellProjection::March, "the device is a processor: a cell costs less to walk through than to draw",
            kWalkedNs / kDrawnNs};
  if (isProcessor)
    return {CellProjection::Silhouette,
            "the device is a processor, and rays cannot walk: an outline costs less than a fan", kOutlinedShare};
  if (tolerance && *tolerance < 2.0 * kFanError)
    return {CellProjection::Silhouette, "rasterised thicknesses may err by more than the tolerance leaves", kFanError};
  return {CellProjection::Pt, "the device has hardware for triangles", kFanError};
}

}  // namespace tetralux::render
