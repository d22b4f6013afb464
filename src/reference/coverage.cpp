#include "reference/coverage.h"

#include <atomic>

#include "base/check.h"
#include "base/parallel.h"
#include "reference/cell_ray.h"
#include "reference/cell_shows.h"
#include "reference/pixel_counts.h"
#include "reference/pixel_tiles.h"
#include "reference/ray_interval.h"
#include "reference/surface_tiles.h"

namespace tetralux::reference {
namespace {

bool isEmpty(const glm::vec4& pixel) { return pixel == glm::vec4(0.0f); }

void markSurfaces(const ReferenceScene& scene, std::vector<std::uint8_t>& covered) {
  const SurfaceTiles tiles(scene.data->surfaces, scene.camera, scene.size);
  parallelFor(scene.size.height, 1, [&](size_t begin, size_t end, unsigned) {
    for (auto y = static_cast<std::uint32_t>(begin); y < end; y++) {
      for (std::uint32_t x = 0; x < scene.size.width; x++) {
        std::uint8_t& flag = covered[static_cast<size_t>(y) * scene.size.width + x];
        if (flag == 0 && tiles.nearest(scene.camera.pixelRay(scene.size, x, y), x, y).surface) flag = 1;
      }
    }
  });
}

}  // namespace

std::vector<std::uint8_t> coveredPixels(const ReferenceScene& scene, const Image& picture) {
  CHECK_EQ(picture.width, scene.size.width);
  CHECK_EQ(picture.height, scene.size.height);
  std::vector<std::uint8_t> covered(picture.pixels.size());
  for (size_t i = 0; i < covered.size(); i++) covered[i] = isEmpty(picture.pixels[i]) ? 0 : 1;
  const PixelCounts empty(scene.size, [&](size_t pixel) { return covered[pixel] == 0; });
  const CellFootprint footprint(scene.camera, scene.size);

  const auto markRays = [&](size_t cell, const PixelBox& box) {
    if (!cellMayShow(scene, cell)) return;
    const CellGeometry geometry(cellVertices(scene.mesh, cell), cellScalars(scene.mesh, scene.field, cell));
    if (geometry.empty()) return;
    const bool isVolumeSeen = volumeMayShow(scene, cell);
    for (std::int32_t y = box.lowY; y <= box.highY; y++) {
      for (std::int32_t x = box.lowX; x <= box.highX; x++) {
        std::uint8_t& flag = covered[static_cast<size_t>(y) * scene.size.width + static_cast<size_t>(x)];
        const std::atomic_ref shared(flag);  // threads meet where cells do
        if (shared.load(std::memory_order_relaxed) != 0) continue;
        const Ray ray = scene.camera.pixelRay(scene.size, x, y);
        CellChord chord;
        if (!geometry.intersect(ray, chord)) continue;
        if (scene.appearance && !cutChord(chord, keptRange(scene.appearance->clip, ray))) continue;
        if (isVolumeSeen || isosurfaceMayShow(scene, chord.segment)) shared.store(1, std::memory_order_relaxed);
      }
    }
  };
  parallelFor(scene.mesh.cellCount(), 1 << 14, [&](size_t begin, size_t end, unsigned) {
    for (size_t cell = begin; cell < end; cell++) {
      const PixelBox box = footprint(cellVertices(scene.mesh, cell));
      if (empty.count(box) > 0) markRays(cell, box);
    }
  });
  if (scene.appearance && !scene.data->surfaces.empty()) markSurfaces(scene, covered);
  return covered;
}

}  // namespace tetralux::reference
