#include "mesh/boundary.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "mesh/vertex_buckets.h"

namespace tetralux {
namespace {

constexpr size_t kCellsAtOnce = 1 << 16;

}  // namespace

std::vector<BoundaryFace> listBoundary(const TetMesh& mesh, const Adjacency& adjacency) {
  std::vector<std::vector<BoundaryFace>> parts((mesh.cellCount() + kCellsAtOnce - 1) / kCellsAtOnce);
  parallelFor(mesh.cellCount(), kCellsAtOnce, [&](size_t begin, size_t end, unsigned) {
    for (size_t cell = begin; cell < end; cell++) {
      const auto& neighbors = adjacency.neighbors[cell];
      if (std::find(neighbors.begin(), neighbors.end(), kNoCell) == neighbors.end()) continue;
      const CellVertices v = sortedVertices(mesh.cells[cell]);
      if (hasRepeatedVertex(v)) continue;
      for (std::uint32_t k = 0; k < 4; k++) {
        if (neighbors[k] != kNoCell) continue;
        BoundaryFace face{{v[k == 0 ? 1 : 0], v[k <= 1 ? 2 : 1], v[k <= 2 ? 3 : 2]}, static_cast<std::uint32_t>(cell)};
        if ((adjacency.sides[cell] >> k & 1) != 0) std::swap(face.vertices[1], face.vertices[2]);
        parts[begin / kCellsAtOnce].push_back(face);
      }
    }
  });
  size_t count = 0;
  for (const auto& part : parts) count += part.size();
  std::vector<BoundaryFace> boundary;
  boundary.reserve(count);
  for (const auto& part : parts) boundary.insert(boundary.end(), part.begin(), part.end());
  return boundary;
}

bool isConvexSurface(const TetMesh& mesh, const std::vector<BoundaryFace>& faces) {
  struct Edge {
    std::uint64_t ends;  // the smaller vertex in the upper half
    std::uint32_t face;
  };
  std::vector<Edge> edges;
  edges.reserve(faces.size() * 3);
  for (std::uint32_t f = 0; f < faces.size(); f++) {
    for (size_t i = 0; i < 3; i++) {
      const auto [low, high] = std::minmax(faces[f].vertices[i], faces[f].vertices[(i + 1) % 3]);
      edges.push_back({std::uint64_t{low} << 32 | high, f});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
  const double tolerance = 1e-9 * mesh.bounds().diagonal();
  std::vector<std::uint32_t> parent(faces.size());
  for (std::uint32_t f = 0; f < parent.size(); f++) parent[f] = f;
  const auto root = [&](std::uint32_t f) {
    while (parent[f] != f) f = parent[f] = parent[parent[f]];
    return f;
  };
  size_t components = faces.size();
  for (size_t i = 0; i < edges.size(); i += 2) {
    // Exactly two faces at every edge, otherwise the surface is not closed or touches itself.
    if (i + 1 == edges.size() || edges[i].ends != edges[i + 1].ends) return false;
    if (i + 2 < edges.size() && edges[i + 2].ends == edges[i].ends) return false;
    const BoundaryFace& face = faces[edges[i].face];
    const BoundaryFace& other = faces[edges[i + 1].face];
    const glm::dvec3 a = mesh.point(face.vertices[0]);
    const glm::dvec3 normal = glm::cross(mesh.point(face.vertices[1]) - a, mesh.point(face.vertices[2]) - a);
    const double length = glm::length(normal);
    for (const std::uint32_t vertex : other.vertices) {
      if (glm::dot(normal, mesh.point(vertex) - a) > tolerance * length) return false;
    }
    const std::uint32_t r0 = root(edges[i].face);
    const std::uint32_t r1 = root(edges[i + 1].face);
    if (r0 != r1) {
      parent[r0] = r1;
      components--;
    }
  }
  return components == 1;
}

}  // namespace tetralux
