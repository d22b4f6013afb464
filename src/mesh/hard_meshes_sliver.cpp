#include <utility>
#include <vector>

#include "base/check.h"
#include "mesh/hard_meshes.h"

namespace tetralux {

// Why no two cells overlap: seen along z, cell k is the parallelogram of the vertices k to k + 3, with the diagonals
// (k, k + 3) and (k + 1, k + 2). Cells two or more apart share at most an edge of their outlines. Cells k and k + 1
// share the triangle (k + 1, k + 2, k + 3), and lie on different sides of it: the height of (k, k + 3) over
// (k + 1, k + 2) where they cross, (z_k - z_{k+1} - z_{k+2} + z_{k+3}) / 2 = (-q)^k (1 + q)^2 (1 - q) / 2, alternates.
TetMesh sliverChain(std::uint32_t count, double heightRatio, const FieldFunction& field) {
  CHECK_LE(1u, count);
  CHECK(heightRatio > 0.0 && heightRatio < 1.0);
  TetMesh mesh;
  std::vector<glm::dvec3> points(size_t{count} + 3);
  double z = 1.0;
  for (size_t k = 0; k < points.size(); k++) {
    points[k] = {0.5 * static_cast<double>(k), static_cast<double>(k % 2), z};
    z *= -heightRatio;
  }
  mesh.cells.resize(count);
  for (std::uint32_t k = 0; k < count; k++) mesh.cells[k] = {k, k + 2, k + 1, k + 3};
  mesh.points = std::move(points);
  addPreferredField(mesh, "scalar", field);
  return mesh;
}

}  // namespace tetralux
