#include "render/pass_work.h"

#include "shared/limits.h"

namespace tetralux::render {
namespace {

constexpr std::uint64_t kCellBytes = 16;    // four vertex indices
constexpr std::uint64_t kVertexBytes = 16;  // position and scalar
constexpr std::uint64_t kKeyBytes = 4;
constexpr std::uint64_t kFanBytes = shared::FAN_VERTICES * 24 + 4;

// Of the march: a face's three vertices and code; a job, a link of a list, its rank and code; a list's first node; what
// lies across a face of a cell; a pixel's colour.
constexpr std::uint64_t kFaceBytes = 16;
constexpr std::uint64_t kJobBytes = 16;
constexpr std::uint64_t kNodeBytes = 12;
constexpr std::uint64_t kHeadBytes = 4;
constexpr std::uint64_t kAcrossBytes = 8;
constexpr std::uint64_t kColorBytes = 16;

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

// A closed surface of triangles has half as many vertices as faces. Jobs are written and read; lists and colours are
// emptied, and a node is exchanged with its list's first.
PassWork enterWork(const MarchWork& march, std::uint64_t pixels, std::uint64_t vertexBytes) {
  const std::uint64_t bytes = march.faces * kFaceBytes + march.faces / 2 * vertexBytes + march.jobs * 2 * kJobBytes +
                              march.entries * (kNodeBytes + 2 * kHeadBytes) + pixels * (kHeadBytes + kColorBytes);
  return {
      "enter", bytes, march.jobs, "jobs", {{"faces", march.faces}, {"jobs", march.jobs}, {"entries", march.entries}}};
}

// What rays ask for, caches or not: at an entry its node, cell and three vertices, at a step what lies across a face
// and a vertex. The control points of the transfer function are left out: there are few, and every ray reads the same
// ones.
PassWork marchWork(const MarchWork& march, std::uint64_t pixels, std::uint64_t vertexBytes, std::uint64_t targetBytes) {
  const std::uint64_t bytes = march.entries * (kNodeBytes + kCellBytes + 3 * vertexBytes) +
                              march.cells * (kAcrossBytes + vertexBytes) +
                              pixels * (kHeadBytes + kColorBytes + targetBytes);
  return {"march", bytes, march.cells, "cells", {{"cells", march.cells}, {"parts", march.parts}}};
}

}  // namespace

std::vector<PassWork> passWork(const FrameStats& stats, std::uint64_t cells, std::uint64_t points, ImageSize size) {
  const std::uint64_t pixels = std::uint64_t{size.width} * size.height;
  const std::uint64_t picture = pixels * pixelBytes(stats.target);
  const std::uint64_t drawn = stats.drawnCells;
  const std::uint64_t vertices = points * kVertexBytes;
  // With what single precision leaves of a position.
  const std::uint64_t walkVertexBytes = stats.doublePrecision ? 2 * kVertexBytes : kVertexBytes;
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
    else if (pass == "enter" && stats.march)
      work.push_back(enterWork(*stats.march, pixels, walkVertexBytes));
    else if (pass == "march" && stats.march)
      work.push_back(marchWork(*stats.march, pixels, walkVertexBytes, pixelBytes(stats.target)));
    else
      work.push_back({pass, std::nullopt, std::nullopt, ""});
  }
  return work;
}

}  // namespace tetralux::render
