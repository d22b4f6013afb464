#include "reference/ray_caster.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <tuple>

#include "base/check.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "reference/cell_ray.h"
#include "reference/piece_count.h"
#include "reference/pixel_counts.h"
#include "reference/pixel_tiles.h"
#include "reference/ray_painter.h"
#include "reference/segment_integral.h"
#include "reference/surface_tiles.h"

namespace tetralux::reference {
namespace {

// A wanted pixel: where it is and which element of the result it fills.
struct Target {
  PixelPosition position;
  size_t result = 0;
};

struct RaySegment {
  CellSegment segment;
  std::uint32_t cell;

  double middle() const { return 0.5 * (segment.front + segment.back); }
};

ReferencePixel composite(std::vector<RaySegment>& segments, const TransferFunction& transfer, double lengthPerDepth) {
  std::sort(segments.begin(), segments.end(), [](const RaySegment& a, const RaySegment& b) {
    return a.middle() != b.middle() ? a.middle() < b.middle() : a.cell < b.cell;
  });
  ReferencePixel pixel;
  pixel.layers = static_cast<std::uint32_t>(segments.size());
  double transmittance = 1.0;
  for (const RaySegment& s : segments) {
    const SegmentOptics optics = integrateSegment(transfer, s.segment.sFront, s.segment.sBack,
                                                  (s.segment.back - s.segment.front) * lengthPerDepth);
    pixel.pieces += pieceCount(transfer, s.segment.sFront, s.segment.sBack);
    pixel.light += transmittance * optics.light;
    pixel.alpha += (1.0 - pixel.alpha) * optics.alpha;
    transmittance *= 1.0 - optics.alpha;
  }
  return pixel;
}

// What rays need of a scene with an appearance.
struct AppearanceCaster {
  RayPainter painter;
  SurfaceTiles surfaces;

  explicit AppearanceCaster(const ReferenceScene& scene)
      : painter(scene), surfaces(scene.data->surfaces, scene.camera, scene.size) {}
};

// Casts the rays of one tile's targets, which are sorted by row.
class TileCaster {
 public:
  //   appearance   null: the volume alone
  TileCaster(const ReferenceScene& scene, const CellFootprint& footprint, const AppearanceCaster* appearance)
      : scene_(scene), footprint_(footprint), appearance_(appearance) {}

  void cast(std::span<const Target> targets, std::span<const std::uint32_t> cells,
            std::vector<ReferencePixel>& result) {
    rays_.clear();
    segments_.resize(std::max(segments_.size(), targets.size()));
    for (size_t i = 0; i < targets.size(); i++) {
      rays_.push_back(scene_.camera.pixelRay(scene_.size, targets[i].position.x, targets[i].position.y));
      segments_[i].clear();
    }
    for (const std::uint32_t cell : cells) collect(cell, targets);
    for (size_t i = 0; i < targets.size(); i++)
      result[targets[i].result] = appearance_ ? paint(i, targets[i].position)
                                              : composite(segments_[i], scene_.transfer, rays_[i].lengthPerDepth);
  }

 private:
  ReferencePixel paint(size_t i, const PixelPosition& position) {
    cells_.clear();
    for (const RaySegment& segment : segments_[i]) cells_.push_back(segment.cell);
    const SurfaceHit hit = appearance_->surfaces.nearest(rays_[i], position.x, position.y);
    return appearance_->painter.paint(rays_[i], cells_, hit);
  }

  void collect(std::uint32_t cell, std::span<const Target> targets) {
    const auto vertices = cellVertices(scene_.mesh, cell);
    const PixelBox box = footprint_(vertices);
    if (box.empty()) return;
    const auto rowOf = [](const Target& t) { return static_cast<std::int32_t>(t.position.y); };
    auto target =
        std::partition_point(targets.begin(), targets.end(), [&](const Target& t) { return rowOf(t) < box.lowY; });
    std::optional<CellGeometry> geometry;  // made for the first target in the box: mostly there is none
    for (; target != targets.end() && rowOf(*target) <= box.highY; ++target) {
      const auto x = static_cast<std::int32_t>(target->position.x);
      if (x < box.lowX || x > box.highX) continue;
      if (!geometry) geometry.emplace(vertices, cellScalars(scene_.mesh, scene_.field, cell));
      if (geometry->empty()) return;
      const size_t i = static_cast<size_t>(target - targets.begin());
      CellSegment segment;
      if (geometry->intersect(rays_[i], segment)) segments_[i].push_back({segment, cell});
    }
  }

  const ReferenceScene& scene_;
  const CellFootprint& footprint_;
  const AppearanceCaster* appearance_;
  std::vector<std::uint32_t> cells_;
  std::vector<Ray> rays_;
  std::vector<std::vector<RaySegment>> segments_;
};

// The targets of a tile, sorted by row; the span may refer to `storage`.
using TileTargets = std::function<std::span<const Target>(std::uint32_t tile, std::vector<Target>& storage)>;

//   wanted   the targets' pixels; null: all
void castTiles(const ReferenceScene& scene, const PixelCounts* wanted, const TileTargets& targetsOf,
               std::vector<ReferencePixel>& result) {
  const CellFootprint footprint(scene.camera, scene.size);
  const PixelTiles tiles(scene.mesh, footprint, scene.size, wanted);
  const size_t tileCount = static_cast<size_t>(tiles.columns()) * tiles.rows();
  std::optional<AppearanceCaster> appearance;
  if (scene.appearance) appearance.emplace(scene);
  std::vector<TileCaster> casters(workerCount(), TileCaster(scene, footprint, appearance ? &*appearance : nullptr));
  std::vector<std::vector<Target>> storages(workerCount());
  Progress progress("reference", tileCount);
  parallelFor(tileCount, 1, [&](size_t begin, size_t end, unsigned worker) {
    for (size_t i = begin; i < end; i++) {
      const auto tile = static_cast<std::uint32_t>(i);
      casters[worker].cast(targetsOf(tile, storages[worker]), tiles.cells(tile), result);
      progress.advance();
    }
  });
}

constexpr auto kSide = static_cast<std::uint32_t>(PixelTiles::kSide);

}  // namespace

std::vector<ReferencePixel> renderPixels(const ReferenceScene& scene) {
  const ImageSize size = scene.size;
  const std::uint32_t columns = PixelTiles::columnsOf(size);
  std::vector<ReferencePixel> result(static_cast<size_t>(size.width) * size.height);
  castTiles(
      scene, nullptr,
      [&](std::uint32_t tile, std::vector<Target>& storage) {
        const std::uint32_t x0 = tile % columns * kSide;
        const std::uint32_t y0 = tile / columns * kSide;
        storage.clear();
        for (std::uint32_t y = y0; y < std::min(y0 + kSide, size.height); y++) {
          for (std::uint32_t x = x0; x < std::min(x0 + kSide, size.width); x++)
            storage.push_back({{x, y}, static_cast<size_t>(y) * size.width + x});
        }
        return std::span<const Target>(storage);
      },
      result);
  return result;
}

std::vector<ReferencePixel> renderPixels(const ReferenceScene& scene, std::span<const PixelPosition> positions) {
  const std::uint32_t columns = PixelTiles::columnsOf(scene.size);
  const auto tileOf = [&](const PixelPosition& p) { return (p.y / kSide) * columns + p.x / kSide; };
  std::vector<Target> targets(positions.size());
  std::vector<size_t> starts(static_cast<size_t>(columns) * PixelTiles::rowsOf(scene.size) + 1, 0);
  std::vector<bool> wanted(static_cast<size_t>(scene.size.width) * scene.size.height, false);
  for (size_t i = 0; i < positions.size(); i++) {
    CHECK_LT(positions[i].x, scene.size.width);
    CHECK_LT(positions[i].y, scene.size.height);
    targets[i] = {positions[i], i};
    starts[tileOf(positions[i]) + 1]++;
    wanted[static_cast<size_t>(positions[i].y) * scene.size.width + positions[i].x] = true;
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::sort(targets.begin(), targets.end(), [&](const Target& a, const Target& b) {
    const auto key = [&](const Target& t) {
      return std::tuple(tileOf(t.position), t.position.y, t.position.x, t.result);
    };
    return key(a) < key(b);
  });
  std::vector<ReferencePixel> result(positions.size());
  const PixelCounts wantedCounts(scene.size, [&](size_t pixel) { return wanted[pixel]; });
  castTiles(
      scene, &wantedCounts,
      [&](std::uint32_t tile, std::vector<Target>&) {
        return std::span<const Target>(targets).subspan(starts[tile], starts[tile + 1] - starts[tile]);
      },
      result);
  return result;
}

Image toImage(const std::vector<ReferencePixel>& pixels, ImageSize size) {
  CHECK_EQ(pixels.size(), static_cast<size_t>(size.width) * size.height);
  Image image(size.width, size.height);
  for (size_t i = 0; i < pixels.size(); i++) image.pixels[i] = glm::vec4(glm::dvec4(pixels[i].light, pixels[i].alpha));
  return image;
}

}  // namespace tetralux::reference
