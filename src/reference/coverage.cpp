#include "reference/coverage.h"

#include <algorithm>
#include <atomic>

#include "base/check.h"
#include "base/parallel.h"
#include "reference/cell_ray.h"
#include "reference/pixel_counts.h"
#include "reference/pixel_tiles.h"

namespace tetralux::reference {
namespace {

bool isEmpty(const glm::vec4& pixel) { return pixel == glm::vec4(0.0f); }

}  // namespace

std::vector<std::uint8_t> coveredPixels(const ReferenceScene& scene, const Image& picture) {
  CHECK_EQ(picture.width, scene.size.width);
  CHECK_EQ(picture.height, scene.size.height);
  std::vector<std::uint8_t> covered(picture.pixels.size());
  for (size_t i = 0; i < covered.size(); i++) covered[i] = isEmpty(picture.pixels[i]) ? 0 : 1;
  const PixelCounts empty(scene.size, [&](size_t pixel) { return covered[pixel] == 0; });
  const CellFootprint footprint(scene.camera, scene.size);

  const auto markRays = [&](size_t cell, const PixelBox& box) {
    const auto scalars = cellScalars(scene.mesh, scene.field, cell);
    const auto [low, high] = std::minmax_element(scalars.begin(), scalars.end());
    if (scene.transfer.isTransparent(*low, *high)) return;
    const CellGeometry geometry(cellVertices(scene.mesh, cell), scalars);
    if (geometry.empty()) return;
    for (std::int32_t y = box.lowY; y <= box.highY; y++) {
      for (std::int32_t x = box.lowX; x <= box.highX; x++) {
        std::uint8_t& flag = covered[static_cast<size_t>(y) * scene.size.width + static_cast<size_t>(x)];
        const std::atomic_ref shared(flag);  // threads meet where cells do
        if (shared.load(std::memory_order_relaxed) != 0) continue;
        CellSegment segment;
        if (geometry.intersect(scene.camera.pixelRay(scene.size, x, y), segment))
          shared.store(1, std::memory_order_relaxed);
      }
    }
  };
  parallelFor(scene.mesh.cellCount(), 1 << 14, [&](size_t begin, size_t end, unsigned) {
    for (size_t cell = begin; cell < end; cell++) {
      const PixelBox box = footprint(cellVertices(scene.mesh, cell));
      if (empty.count(box) > 0) markRays(cell, box);
    }
  });
  return covered;
}

}  // namespace tetralux::reference
