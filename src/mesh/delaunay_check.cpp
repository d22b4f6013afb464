#include "mesh/delaunay_check.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/circumcenters.h"

namespace tetralux {
namespace {

// Of the radius: cospherical neighbours are on the sphere up to rounding.
constexpr double kTolerance = 1e-9;

bool holdsAVertexOf(const TetMesh& mesh, std::uint32_t cell, std::uint32_t neighbor) {
  const CellVertices& v = mesh.cells[cell];
  const glm::dvec3 first = mesh.point(v[0]);
  const glm::dvec3 center = circumcenter(first, mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]));
  const double radius = glm::length(center);
  return std::any_of(mesh.cells[neighbor].begin(), mesh.cells[neighbor].end(), [&](std::uint32_t vertex) {
    if (std::find(v.begin(), v.end(), vertex) != v.end()) return false;
    return glm::length(mesh.point(vertex) - first - center) < radius * (1.0 - kTolerance);
  });
}

}  // namespace

bool looksDelaunay(const TetMesh& mesh, const Adjacency& adjacency, size_t samples) {
  const size_t count = mesh.cellCount();
  const size_t step = std::max<size_t>(1, count / std::max<size_t>(1, samples));
  for (size_t cell = 0; cell < count; cell += step) {
    for (const std::uint32_t neighbor : adjacency.neighbors[cell]) {
      if (neighbor != kNoCell && holdsAVertexOf(mesh, static_cast<std::uint32_t>(cell), neighbor)) return false;
    }
  }
  return true;
}

}  // namespace tetralux
