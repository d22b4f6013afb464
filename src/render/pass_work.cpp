#include "render/pass_work.h"

#include "shared/limits.h"

namespace tetralux::render {
namespace {

constexpr std::uint64_t kCellBytes = 16;    // four vertex indices
constexpr std::uint64_t kVertexBytes = 16;  // position and scalar
constexpr std::uint64_t kKeyBytes = 4;
constexpr std::uint64_t kFanBytes = shared::FAN_VERTICES * 24 + 4;

std::uint64_t pixelBytes(Target target) {
  if (target == Target::Rgba32f) return 16;
  return target == Target::Rgba8 || target == Target::Rgba8Dither ? 4 : 8;
}

// Three rounds of eight bits, each reading keys to count them, then keys and indices to move them; there are no indices
// before the first round, which drops what is culled.
std::uint64_t sortBytes(std::uint64_t cells, std::uint64_t kept) {
  const std::uint64_t first = cells * (kKeyBytes + kKeyBytes) + kept * 2 * kKeyBytes;
  const std::uint64_t other = kept * (kKeyBytes + 4 * kKeyBytes);
  return first + 2 * other;
}

}  // namespace

std::vector<PassWork> passWork(const FrameStats& stats, std::uint64_t cells, std::uint64_t points, ImageSize size) {
  const std::uint64_t picture = std::uint64_t{size.width} * size.height * pixelBytes(stats.target);
  const std::uint64_t drawn = stats.drawnCells;
  const std::uint64_t vertices = points * kVertexBytes;
  const bool isGator = stats.projection == CellProjection::Gator;
  std::vector<PassWork> work;
  for (const gpu::PassTime& time : stats.passes) {
    const std::string& pass = time.name;
    if (pass == "cull")
      work.push_back({pass, cells * (kCellBytes + kKeyBytes) + vertices, cells, "cells"});
    else if (pass == "sort" && stats.order.order == Order::Radix)
      work.push_back({pass, sortBytes(cells, drawn), drawn, "cells"});
    else if (pass == "project")
      work.push_back({pass, drawn * (kKeyBytes + kCellBytes + kFanBytes) + vertices, drawn, "cells"});
    else if (pass == "raster")
      work.push_back({pass, picture + drawn * (isGator ? kKeyBytes + kCellBytes : kFanBytes) + (isGator ? vertices : 0),
                      stats.triangles, "triangles"});
    else
      work.push_back({pass, std::nullopt, std::nullopt, ""});
  }
  return work;
}

}  // namespace tetralux::render
