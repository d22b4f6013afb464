#include "reference/cell_shows.h"

#include <algorithm>

#include "reference/pixel_tiles.h"

namespace tetralux::reference {
namespace {

// Share of the field's range by which a ray's scalar may differ from the cell's own.
constexpr double kScalarTolerance = 1e-9;

struct Range {
  double low = 0.0;
  double high = 0.0;
};

Range rangeInCell(const TetMesh& mesh, const std::vector<double>& values, size_t cell) {
  const CellVertices& v = mesh.cells[cell];
  const auto [low, high] = std::minmax({values[v[0]], values[v[1]], values[v[2]], values[v[3]]});
  return {low, high};
}

Range scalarRange(const ReferenceScene& scene, size_t cell) {
  const auto scalars = cellScalars(scene.mesh, scene.field, cell);
  const auto [low, high] = std::minmax_element(scalars.begin(), scalars.end());
  return {*low, *high};
}

bool isZero(const FactorCurve& curve, const Range& range) {
  if (curve.at(range.low).factor > 0.0 || curve.at(range.high).factor > 0.0) return false;
  return std::none_of(curve.points().begin(), curve.points().end(), [&](const FactorPoint& point) {
    return point.value >= range.low && point.value <= range.high && point.factor > 0.0;
  });
}

bool isTransparent(const TransferFunction2d& transfer, const Range& scalars, const Range& gradients) {
  // Samples between which a range lies, both included.
  const auto indices = [](const std::vector<double>& axis, const Range& range) {
    const auto above = std::upper_bound(axis.begin(), axis.end(), range.low) - axis.begin();
    const auto below = std::lower_bound(axis.begin(), axis.end(), range.high) - axis.begin();
    const auto size = static_cast<std::ptrdiff_t>(axis.size());
    return std::pair(static_cast<size_t>(std::max<std::ptrdiff_t>(above - 1, 0)),
                     static_cast<size_t>(std::min(below, size - 1)));
  };
  const auto [firstScalar, lastScalar] = indices(transfer.scalars(), scalars);
  const auto [firstGradient, lastGradient] = indices(transfer.gradients(), gradients);
  for (size_t j = firstGradient; j <= lastGradient; j++) {
    for (size_t i = firstScalar; i <= lastScalar; i++) {
      if (transfer.samples()[i + j * transfer.scalars().size()].extinction > 0.0) return false;
    }
  }
  return true;
}

bool isTransparent(const ReferenceScene& scene, size_t cell) {
  const Appearance& appearance = *scene.appearance;
  if (appearance.rgbaField) {
    const CellVertices& vertices = scene.mesh.cells[cell];
    return std::none_of(vertices.begin(), vertices.end(),
                        [&](std::uint32_t vertex) { return scene.data->rgba[vertex].w > 0.0; });
  }
  const Range scalars = scalarRange(scene, cell);
  if (appearance.transfer2d) {
    return isTransparent(*appearance.transfer2d, scalars,
                         rangeInCell(scene.mesh, scene.data->gradientMagnitudes, cell));
  }
  return scene.transfer.isTransparent(scalars.low, scalars.high);
}

}  // namespace

bool volumeMayShow(const ReferenceScene& scene, size_t cell) {
  if (!scene.appearance) {
    const Range scalars = scalarRange(scene, cell);
    return !scene.transfer.isTransparent(scalars.low, scalars.high);
  }
  const Appearance& appearance = *scene.appearance;
  if (!appearance.volumeVisible || isTransparent(scene, cell)) return false;
  for (size_t i = 0; i < appearance.modulations.size(); i++) {
    const Modulation& modulation = appearance.modulations[i];
    const Range range = modulation.by == ModulatedBy::ViewCosine
                            ? Range{0.0, 1.0}
                            : rangeInCell(scene.mesh, scene.data->modulators[i], cell);
    if (isZero(modulation.curve, range)) return false;
  }
  return true;
}

bool isosurfaceMayShow(const ReferenceScene& scene, const CellSegment& segment) {
  if (!scene.appearance) return false;
  const double tolerance = kScalarTolerance * (scene.field.high - scene.field.low);
  const auto [low, high] = std::minmax(segment.sFront, segment.sBack);
  return std::any_of(scene.appearance->isosurfaces.begin(), scene.appearance->isosurfaces.end(),
                     [&, low = low, high = high](const Isosurface& surface) {
                       return surface.opacity > 0.0 && surface.value >= low - tolerance &&
                              surface.value <= high + tolerance;
                     });
}

bool cellMayShow(const ReferenceScene& scene, size_t cell) {
  const Range scalars = scalarRange(scene, cell);
  return volumeMayShow(scene, cell) || isosurfaceMayShow(scene, {0.0, 1.0, scalars.low, scalars.high});
}

}  // namespace tetralux::reference
