#include "reference/pixel_tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "base/parallel.h"
#include "reference/pixel_counts.h"

namespace tetralux::reference {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Rounding of a projected coordinate is far below this share of a pixel.
constexpr double kPixelMargin = 1e-6;

struct Range {
  double low = kInfinity;
  double high = -kInfinity;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// First and last pixel whose centre, at i + 0.5, lies in the range.
void pixelRange(const Range& range, std::uint32_t count, std::int32_t& low, std::int32_t& high) {
  low = static_cast<std::int32_t>(std::clamp(std::ceil(range.low - 0.5 - kPixelMargin), 0.0, double(count)));
  high = static_cast<std::int32_t>(std::clamp(std::floor(range.high - 0.5 + kPixelMargin), -1.0, double(count) - 1.0));
}

}  // namespace

std::array<glm::dvec3, 4> cellVertices(const TetMesh& mesh, size_t cell) {
  const CellVertices& v = mesh.cells[cell];
  return {mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])};
}

std::array<double, 4> cellScalars(const TetMesh& mesh, const ScalarField& field, size_t cell) {
  const std::vector<double>& values = field.values;
  if (field.association == FieldAssociation::Cell) {
    std::array<double, 4> same;
    same.fill(values[cell]);
    return same;
  }
  const CellVertices& v = mesh.cells[cell];
  return {values[v[0]], values[v[1]], values[v[2]], values[v[3]]};
}

CellFootprint::CellFootprint(const Camera& camera, ImageSize size)
    : rotation_(camera.viewRotation()),
      eye_(camera.eye),
      scale_(camera.pixelsPerUnit(size)),
      size_(size),
      perspective_(camera.projection == Projection::Perspective) {}

PixelBox CellFootprint::operator()(std::span<const glm::dvec3> vertices) const {
  std::array<glm::dvec3, 4> view;
  CHECK_LE(vertices.size(), view.size());
  bool anyInFront = false;
  for (size_t i = 0; i < vertices.size(); i++) {
    view[i] = rotation_ * (vertices[i] - eye_);
    anyInFront = anyInFront || view[i].z > 0.0;
  }
  if (!anyInFront) return {};
  Range x;
  Range y;
  for (size_t i = 0; i < vertices.size(); i++) {
    if (!perspective_) {
      x.add(view[i].x);
      y.add(view[i].y);
      continue;
    }
    if (view[i].z > 0.0) {
      x.add(view[i].x / view[i].z);
      y.add(view[i].y / view[i].z);
      continue;
    }
    // An edge that crosses the eye's plane runs off to infinity on the side where it crosses.
    for (size_t j = 0; j < vertices.size(); j++) {
      if (!(view[j].z > 0.0)) continue;
      const double t = view[j].z / (view[j].z - view[i].z);
      const glm::dvec3 crossing = view[j] + t * (view[i] - view[j]);
      const double rounding =
          1e-12 * (std::abs(view[i].x) + std::abs(view[j].x) + std::abs(view[i].y) + std::abs(view[j].y));
      if (crossing.x >= -rounding) x.add(kInfinity);
      if (crossing.x <= rounding) x.add(-kInfinity);
      if (crossing.y >= -rounding) y.add(kInfinity);
      if (crossing.y <= rounding) y.add(-kInfinity);
    }
  }
  const Range column{0.5 * size_.width + scale_ * x.low, 0.5 * size_.width + scale_ * x.high};
  const Range row{0.5 * size_.height - scale_ * y.high, 0.5 * size_.height - scale_ * y.low};
  PixelBox box;
  pixelRange(column, size_.width, box.lowX, box.highX);
  pixelRange(row, size_.height, box.lowY, box.highY);
  return box;
}

PixelTiles::PixelTiles(const TetMesh& mesh, const CellFootprint& footprint, ImageSize size, const PixelCounts* wanted)
    : PixelTiles(
          mesh.cellCount(),
          [&](size_t cell) {
            const PixelBox box = footprint(cellVertices(mesh, cell));
            return box.empty() || (wanted && wanted->count(box) == 0) ? PixelBox{} : box;
          },
          size) {}

PixelTiles::PixelTiles(size_t count, const std::function<PixelBox(size_t)>& boxOf, ImageSize size)
    : columns_(columnsOf(size)), rows_(rowsOf(size)), starts_(static_cast<size_t>(columns_) * rows_ + 1, 0) {
  struct TileBox {
    std::uint16_t lowX, lowY, highX, highY;
  };
  constexpr TileBox kNone{1, 1, 0, 0};
  std::vector<TileBox> boxes(count);
  parallelFor(count, 1 << 14, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) {
      const PixelBox box = boxOf(i);
      boxes[i] =
          box.empty()
              ? kNone
              : TileBox{static_cast<std::uint16_t>(box.lowX / kSide), static_cast<std::uint16_t>(box.lowY / kSide),
                        static_cast<std::uint16_t>(box.highX / kSide), static_cast<std::uint16_t>(box.highY / kSide)};
    }
  });
  const auto forEachTile = [&](const TileBox& box, const auto& visit) {
    for (std::uint32_t y = box.lowY; y <= box.highY; y++) {
      for (std::uint32_t x = box.lowX; x <= box.highX; x++) {
        visit(static_cast<size_t>(y) * columns_ + x);
      }
    }
  };
  for (const TileBox& box : boxes) forEachTile(box, [&](size_t tile) { starts_[tile + 1]++; });
  for (size_t tile = 1; tile < starts_.size(); tile++) starts_[tile] += starts_[tile - 1];
  cells_.resize(starts_.back());
  std::vector<std::uint64_t> next(starts_.begin(), starts_.end() - 1);
  for (size_t i = 0; i < count; i++)
    forEachTile(boxes[i], [&](size_t tile) { cells_[next[tile]++] = static_cast<std::uint32_t>(i); });
}

std::span<const std::uint32_t> PixelTiles::cells(std::uint32_t tile) const {
  return std::span(cells_).subspan(starts_[tile], starts_[tile + 1] - starts_[tile]);
}

}  // namespace tetralux::reference
