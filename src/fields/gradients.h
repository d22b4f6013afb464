// Gradients of point fields at the vertices of a mesh.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "fields/vertex_neighbors.h"
#include "mesh/tet_mesh.h"

namespace tetralux {

// Gradients by weighted least squares over the vertices that share a cell with a vertex, improved twice by what the
// gradients around say of second derivatives; the source derives it, docs/appearance.md has the errors measured.
//
// Exact, to rounding, for linear fields, whatever the shapes of cells: inverted, flat, duplicate. Only differences of
// positions matter, and units of length and value do not. Across a direction in which a vertex's neighbourhood is flat
// (thinner than about 1e-6 of its width) the gradient is 0: it is the one of least length that fits. A vertex without
// neighbours at other places has gradient 0. Never NaN; infinite only where a number of the result is beyond double.
//
// Reads the mesh when it is made, and not later. Takes 15 bytes per cell of a usual mesh (6 cells per vertex) and 28
// while it is made; gradients() takes 8, half of which are the result. On all processors; the same bits every time.
class GradientFit {
 public:
  explicit GradientFit(const TetMesh& mesh);

  // Gradient at every vertex, field units per world unit.
  //   values   finite, one per point
  std::vector<glm::dvec3> gradients(std::span<const double> values) const;

 private:
  glm::dvec3 improvement(size_t vertex, std::span<const double> values, double valueScale,
                         std::span<const glm::dvec3> gradients) const;

  VertexNeighbors neighbors_;
  int exponent_ = 0;                         // of two: the mesh's size
  std::vector<glm::dvec3> points_;           // world / 2^exponent_
  std::vector<double> longestEdgesSquared_;  // at every vertex, of the same space
};

}  // namespace tetralux
