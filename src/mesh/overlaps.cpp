#include "mesh/overlaps.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <mutex>

#include "base/parallel.h"
#include "mesh/connected_parts.h"

namespace tetralux {
namespace {

constexpr size_t kGrain = 1 << 10;

// Penetration that counts, relative to the cells' size: neighbours touch.
constexpr double kTolerance = 1e-9;

using Corners = std::array<glm::dvec3, 4>;

struct Box {
  glm::dvec3 low, high;

  bool meets(const Box& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y &&
           low.z < other.high.z && other.low.z < high.z;
  }
};

Corners cornersOf(const TetMesh& mesh, std::uint32_t cell) {
  Corners corners;
  for (size_t i = 0; i < 4; i++) corners[i] = mesh.point(mesh.cells[cell][i]);
  return corners;
}

Box boxOf(const Corners& c) {
  return {glm::min(glm::min(c[0], c[1]), glm::min(c[2], c[3])), glm::max(glm::max(c[0], c[1]), glm::max(c[2], c[3]))};
}

// Whether two tetrahedra have a common inside: no axis separates them (Gottschalk, Lin and Manocha 1996, for
// tetrahedra: the normals of faces and the products of edges).
bool overlap(const Corners& a, const Corners& b) {
  const auto separates = [&](const glm::dvec3& axis) {
    const double length = glm::length(axis);
    if (length == 0.0) return false;
    double lowA = std::numeric_limits<double>::infinity(), highA = -lowA, lowB = lowA, highB = -lowA;
    for (size_t i = 0; i < 4; i++) {
      // Relative to a common corner: digits are kept far from the origin.
      const double x = glm::dot(axis, a[i] - a[0]) / length;
      const double y = glm::dot(axis, b[i] - a[0]) / length;
      lowA = std::min(lowA, x);
      highA = std::max(highA, x);
      lowB = std::min(lowB, y);
      highB = std::max(highB, y);
    }
    const double tolerance = kTolerance * (highA - lowA + highB - lowB);
    return lowA >= highB - tolerance || lowB >= highA - tolerance;
  };
  constexpr std::array<std::array<size_t, 2>, 6> kEdges = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  constexpr std::array<std::array<size_t, 3>, 4> kFaces = {{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
  for (const auto& f : kFaces) {
    if (separates(glm::cross(a[f[1]] - a[f[0]], a[f[2]] - a[f[0]]))) return false;
    if (separates(glm::cross(b[f[1]] - b[f[0]], b[f[2]] - b[f[0]]))) return false;
  }
  for (const auto& e : kEdges) {
    for (const auto& f : kEdges) {
      // Products of nearly parallel edges point anywhere.
      const glm::dvec3 u = a[e[1]] - a[e[0]];
      const glm::dvec3 v = b[f[1]] - b[f[0]];
      const glm::dvec3 axis = glm::cross(u, v);
      if (glm::length(axis) > 1e-6 * glm::length(u) * glm::length(v) && separates(axis)) return false;
    }
  }
  return true;
}

// Boxes of cells in a uniform grid over all of them, about one to a bin.
class BoxGrid {
 public:
  BoxGrid(const TetMesh& mesh, std::vector<std::uint32_t> cells) : cells_(std::move(cells)) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    all_ = {glm::dvec3(kFar), glm::dvec3(-kFar)};
    for (const std::uint32_t cell : cells_) {
      boxes_.push_back(boxOf(cornersOf(mesh, cell)));
      all_.low = glm::min(all_.low, boxes_.back().low);
      all_.high = glm::max(all_.high, boxes_.back().high);
    }
    side_ = std::clamp(static_cast<int>(std::cbrt(static_cast<double>(cells_.size()))), 1, 128);
    bins_.resize(static_cast<size_t>(side_) * static_cast<size_t>(side_) * static_cast<size_t>(side_));
    for (std::uint32_t i = 0; i < boxes_.size(); i++)
      forEachBin(boxes_[i], [&](size_t bin) { bins_[bin].push_back(i); });
  }

  // Calls visit(cell) once for every cell whose box meets another box.
  template <typename Visit>
  void forEachMeeting(const Box& box, std::vector<std::uint32_t>& found, const Visit& visit) const {
    if (!box.meets(all_)) return;
    found.clear();
    forEachBin(box, [&](size_t bin) { found.insert(found.end(), bins_[bin].begin(), bins_[bin].end()); });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const std::uint32_t i : found) {
      if (boxes_[i].meets(box)) visit(cells_[i]);
    }
  }

 private:
  template <typename Visit>
  void forEachBin(const Box& box, const Visit& visit) const {
    const glm::dvec3 scale = static_cast<double>(side_) / glm::max(all_.high - all_.low, glm::dvec3(1e-300));
    const auto bin = [&](const glm::dvec3& p) {
      const glm::dvec3 index = glm::clamp((p - all_.low) * scale, glm::dvec3(0.0), glm::dvec3(side_ - 1));
      return glm::ivec3(index);
    };
    const glm::ivec3 first = bin(box.low);
    const glm::ivec3 last = bin(box.high);
    for (int z = first.z; z <= last.z; z++) {
      for (int y = first.y; y <= last.y; y++) {
        for (int x = first.x; x <= last.x; x++) visit(static_cast<size_t>((z * side_ + y) * side_ + x));
      }
    }
  }

  std::vector<std::uint32_t> cells_;
  std::vector<Box> boxes_;
  Box all_;
  int side_;
  std::vector<std::vector<std::uint32_t>> bins_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 2>> findOverlaps(const TetMesh& mesh, const Adjacency& adjacency) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  const std::vector<bool> isSuspect = cellsThatMayOverlap(adjacency);
  std::vector<std::uint32_t> suspected;
  for (std::uint32_t cell = 0; cell < isSuspect.size(); cell++) {
    if (isSuspect[cell]) suspected.push_back(cell);
  }
  if (suspected.empty()) return pairs;
  const BoxGrid grid(mesh, std::move(suspected));
  std::mutex mutex;
  parallelFor(mesh.cellCount(), kGrain, [&](size_t begin, size_t end, unsigned) {
    std::vector<std::array<std::uint32_t, 2>> own;
    std::vector<std::uint32_t> found;
    for (size_t i = begin; i < end; i++) {
      const auto cell = static_cast<std::uint32_t>(i);
      const Corners corners = cornersOf(mesh, cell);
      grid.forEachMeeting(boxOf(corners), found, [&](std::uint32_t other) {
        // A pair of two suspects is found from both.
        if (other == cell || (isSuspect[cell] && other < cell)) return;
        if (overlap(corners, cornersOf(mesh, other))) own.push_back({std::min(cell, other), std::max(cell, other)});
      });
    }
    const std::lock_guard lock(mutex);
    pairs.insert(pairs.end(), own.begin(), own.end());
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace tetralux
