// What is known exactly are the field's differences along edges. g_i are the gradients sought at the vertices. With
// second derivatives taken to be constant along an edge e = p_j - p_i,
//
//   f_j - f_i = e . (g_i + g_j) / 2.
//
// A linear fit leaves out e . (g_j - g_i) / 2, which is of the order of the edge's length where the neighbours do not
// lie symmetrically. The least-squares solution with weights w_ij at every vertex,
//
//   M_i g_i = sum_j w_ij e (2 (f_j - f_i) - e . g_j),   M_i = sum_j w_ij e e^T,
//
// is a linear system for all vertices at once, approached here by steps that begin with g = 0:
//
//   g_i += step M_i^-1 sum_j w_ij e (f_j - f_i - e . (g_i + g_j) / 2).
//
// The first one, of length 1, is the linear fit. With D the matrix of the M_i on its diagonal and W that of the w_ij e
// e^T, a step multiplies errors by 1 - step x, x the eigenvalues of D^-1 (D + W) / 2. Weights are the same from both
// ends of an edge, so D + W and D - W are sums of squares, of e . (g_i +- g_j): x lies between 0 and 1, whatever the
// mesh. It is 1 for constant gradients, near 1 for smooth ones, and about 1/2 for what differs from vertex to vertex at
// random. Two more steps are Chebyshev's for x from 0.3 to 1 (Golub and Varga 1961): together they leave 13 % there,
// and never more than all.
#include "fields/gradients.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "base/check.h"
#include "base/parallel.h"
#include "fields/pseudo_inverse.h"

namespace tetralux {
namespace {

constexpr size_t kVerticesAtOnce = 1 << 12;

// The linear fit, then 1 / (0.65 +- 0.35 cos(pi / 4)), from the roots of Chebyshev's polynomial between 0.3 and 1.
constexpr double kSteps[] = {1.0, 1.0 / (0.65 + 0.35 * 0.70710678118654752), 1.0 / (0.65 - 0.35 * 0.70710678118654752)};

// Edges that are shorter, in parts of the longest one at their ends, weigh no more: otherwise two vertices that nearly
// coincide would leave no digits to other directions.
constexpr double kShortestEdge = 1e-2;

// Of M_i: a neighbourhood 1e-6 as thick as wide, or 1e-4 where weights differ as much as they may.
constexpr double kRelativeRank = 1e-12;

// Vertices this near (squared, in parts of the mesh's size) coincide. Keeps weights and gradients far from overflow.
constexpr double kCoincidentSquared = 1e-120;

// The power of two just above a number >= 0.
int exponentAbove(double number) { return number > 0.0 ? std::ilogb(number) + 1 : 0; }

glm::dvec3 scaledByPowerOfTwo(const glm::dvec3& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

// 1 / length^4 of an edge. Errors of the fit grow with the edges' lengths; on random Delaunay cells this power leaves a
// third of the error of 1 / length^2, which would make all edges' residuals count the same.
double weight(double lengthSquared, double longestSquared) {
  return 1.0 / (lengthSquared * std::max(lengthSquared, kShortestEdge * kShortestEdge * longestSquared));
}

}  // namespace

GradientFit::GradientFit(const TetMesh& mesh)
    : neighbors_(mesh), points_(mesh.pointCount()), longestEdgesSquared_(mesh.pointCount()) {
  const Bounds bounds = mesh.bounds();
  const glm::dvec3 halfExtent = 0.5 * bounds.high - 0.5 * bounds.low;
  exponent_ = exponentAbove(std::max({halfExtent.x, halfExtent.y, halfExtent.z}));
  parallelFor(points_.size(), kVerticesAtOnce, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) points_[i] = scaledByPowerOfTwo(mesh.point(i), -exponent_);
  });
  parallelFor(points_.size(), kVerticesAtOnce, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) {
      for (const std::uint32_t j : neighbors_.of(i)) {
        const glm::dvec3 edge = points_[j] - points_[i];
        longestEdgesSquared_[i] = std::max(longestEdgesSquared_[i], glm::dot(edge, edge));
      }
    }
  });
}

std::vector<glm::dvec3> GradientFit::gradients(std::span<const double> values) const {
  CHECK_EQ(values.size(), points_.size());
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  // The scale itself has to be a number.
  constexpr int kLeastExponent = -1000;
  const int valueExponent = std::max(exponentAbove(largest), kLeastExponent);
  const double valueScale = std::ldexp(1.0, -valueExponent);

  std::vector<glm::dvec3> gradients(points_.size(), glm::dvec3(0.0));
  std::vector<glm::dvec3> improved(points_.size());
  for (const double step : kSteps) {
    parallelFor(points_.size(), kVerticesAtOnce, [&](size_t begin, size_t end, unsigned) {
      for (size_t i = begin; i < end; i++)
        improved[i] = gradients[i] + step * improvement(i, values, valueScale, gradients);
    });
    gradients.swap(improved);
  }
  parallelFor(points_.size(), kVerticesAtOnce, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) gradients[i] = scaledByPowerOfTwo(gradients[i], valueExponent - exponent_);
  });
  return gradients;
}

// What a step of length 1 adds.
glm::dvec3 GradientFit::improvement(size_t vertex, std::span<const double> values, double valueScale,
                                    std::span<const glm::dvec3> gradients) const {
  glm::dmat3 matrix(0.0);
  glm::dvec3 rightSide(0.0);
  const double value = valueScale * values[vertex];
  for (const std::uint32_t j : neighbors_.of(vertex)) {
    const glm::dvec3 edge = points_[j] - points_[vertex];
    const double lengthSquared = glm::dot(edge, edge);
    if (lengthSquared < kCoincidentSquared) continue;
    const glm::dvec3 weighted =
        weight(lengthSquared, std::max(longestEdgesSquared_[vertex], longestEdgesSquared_[j])) * edge;
    const double residual = valueScale * values[j] - value - 0.5 * glm::dot(edge, gradients[vertex] + gradients[j]);
    matrix += glm::outerProduct(weighted, edge);
    rightSide += residual * weighted;
  }
  return pseudoInverse(matrix, kRelativeRank) * rightSide;
}

}  // namespace tetralux
