#include "mesh/cospherical.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "mesh/orientation.h"
#include "mesh/vertex_buckets.h"

namespace tetralux {
namespace {

constexpr size_t kGrain = 1 << 14;

using CellPair = std::pair<std::uint32_t, std::uint32_t>;

struct Findings {
  std::vector<CellPair> cospherical;  // each face once
  std::vector<std::uint32_t> flat;
};

class CosphericalFinder {
 public:
  CosphericalFinder(const TetMesh& mesh, const Adjacency& adjacency, const std::vector<glm::dvec3>& centers)
      : mesh_(mesh), adjacency_(adjacency), centers_(centers) {}

  bool isFlat(std::uint32_t cell) const {
    const CellVertices& v = mesh_.cells[cell];
    return orientationSign(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3])) == 0;
  }

  void look(std::uint32_t cell, Findings& findings) const {
    if (isFlat(cell)) {
      findings.flat.push_back(cell);
      return;
    }
    for (const std::uint32_t neighbor : adjacency_.neighbors[cell]) {
      if (neighbor != kNoCell && cell < neighbor && areCospherical(cell, neighbor) && !isFlat(neighbor))
        findings.cospherical.emplace_back(cell, neighbor);
    }
  }

 private:
  glm::dvec3 firstVertex(std::uint32_t cell) const {
    const CellVertices& v = mesh_.cells[cell];
    return mesh_.point(*std::min_element(v.begin(), v.end()));
  }

  bool areCospherical(std::uint32_t a, std::uint32_t b) const {
    const glm::dvec3 apart = (firstVertex(b) - firstVertex(a)) + (centers_[b] - centers_[a]);
    return glm::length(apart) <= kCosphericalTolerance * std::min(glm::length(centers_[a]), glm::length(centers_[b]));
  }

  const TetMesh& mesh_;
  const Adjacency& adjacency_;
  const std::vector<glm::dvec3>& centers_;
};

}  // namespace

std::vector<std::uint32_t> cosphericalCells(const TetMesh& mesh, const Adjacency& adjacency,
                                            const std::vector<glm::dvec3>& centers) {
  const CosphericalFinder finder(mesh, adjacency, centers);
  std::vector<Findings> findings(workerCount());
  parallelFor(mesh.cellCount(), kGrain, [&](size_t begin, size_t end, unsigned worker) {
    for (size_t i = begin; i < end; i++) finder.look(static_cast<std::uint32_t>(i), findings[worker]);
  });

  // Union of sets whose root is their lowest cell; the result does not depend on the order of the pairs.
  std::vector<std::uint32_t> parent(mesh.cellCount());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t cell) {
    while (parent[cell] != cell) cell = parent[cell] = parent[parent[cell]];
    return cell;
  };
  for (const Findings& found : findings) {
    for (const auto& [a, b] : found.cospherical) {
      const std::uint32_t rootA = root(a);
      const std::uint32_t rootB = root(b);
      parent[std::max(rootA, rootB)] = std::min(rootA, rootB);
    }
  }
  for (std::uint32_t cell = 0; cell < parent.size(); cell++) parent[cell] = root(cell);

  for (const Findings& found : findings) {
    for (const std::uint32_t cell : found.flat) {
      const auto& neighbors = adjacency.neighbors[cell];
      const auto other = std::find_if(neighbors.begin(), neighbors.end(), [&](std::uint32_t neighbor) {
        return neighbor != kNoCell && !finder.isFlat(neighbor);
      });
      if (other != neighbors.end()) parent[cell] = parent[*other];
    }
  }
  return parent;
}

}  // namespace tetralux
