#include "mesh/circumcenters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/generate.h"
#include "mesh/orientation.h"
#include "mesh/random.h"
#include "mesh/vertex_buckets.h"
#include "support/tilted.h"

namespace tetralux {
namespace {

__extension__ typedef __float128 Quadruple;

using Corners = std::array<glm::dvec3, 4>;

glm::dvec3 centerOf(const Corners& p) { return circumcenter(p[0], p[1], p[2], p[3]); }

double longestEdge(const Corners& p) {
  double longest = 0.0;
  for (const glm::dvec3& a : p) {
    for (const glm::dvec3& b : p) longest = std::max(longest, glm::length(b - a));
  }
  return longest;
}

// How far the distances from a point, given relative to the first corner, to the others differ from that to the first,
// computed in 113-bit floats. Half the difference of squares over the radius is the difference of distances.
double largestDeviation(const Corners& p, const glm::dvec3& center) {
  double largest = 0.0;
  for (int i = 1; i < 4; i++) {
    Quadruple difference = 0;  // |v|^2 - 2 v . x
    Quadruple square = 0;
    for (int axis = 0; axis < 3; axis++) {
      const Quadruple v = Quadruple(p[i][axis]) - Quadruple(p[0][axis]);
      difference += v * (v - 2 * Quadruple(center[axis]));
      square += Quadruple(center[axis]) * Quadruple(center[axis]);
    }
    const double radius = std::sqrt(static_cast<double>(square));
    largest = std::max(largest, std::abs(static_cast<double>(difference)) / (2.0 * radius));
  }
  return largest;
}

// What the header promises.
double tolerance(const Corners& p, const glm::dvec3& center) {
  return 0x1p-37 * longestEdge(p) + 0x1p-52 * glm::length(center);
}

Corners randomCorners(std::uint64_t seed, std::uint64_t index) {
  Corners p;
  for (std::uint64_t i = 0; i < 12; i++) p[i / 3][static_cast<int>(i % 3)] = randomUnit(seed, 12 * index + i);
  return p;
}

TEST(Circumcenter, OfACornerOfACube) {
  const Corners p = {glm::dvec3(1, 2, 3), {3, 2, 3}, {1, 4, 3}, {1, 2, 5}};
  EXPECT_EQ(centerOf(p), glm::dvec3(1.0));
}

TEST(Circumcenter, IsAsFarFromEveryVertex) {
  for (std::uint64_t i = 0; i < 20000; i++) {
    const Corners p = randomCorners(1, i);
    const glm::dvec3 center = centerOf(p);
    ASSERT_LE(largestDeviation(p, center), tolerance(p, center)) << i;
  }
}

TEST(Circumcenter, DoesNotSufferFromADistanceToTheOrigin) {
  for (std::uint64_t i = 0; i < 2000; i++) {
    Corners p = randomCorners(2, i);
    for (glm::dvec3& corner : p) corner += glm::dvec3(1e6, -1e6, 1e6);
    const glm::dvec3 center = centerOf(p);
    ASSERT_LE(largestDeviation(p, center), tolerance(p, center)) << i;
  }
}

// From fat to heights of 1e-25 edges, flat in an oblique plane.
TEST(Circumcenter, OfSlivers) {
  const glm::dvec3 u(0.36, 0.48, -0.8);
  const glm::dvec3 v(-0.8, 0.6, 0.0);
  const glm::dvec3 w(0.48, 0.64, 0.6);
  for (double height = 1.0; height > 1e-25; height *= 0.125) {
    for (std::uint64_t i = 0; i < 100; i++) {
      Corners p = randomCorners(3, i);
      for (glm::dvec3& corner : p) corner = corner.x * u + corner.y * v + height * corner.z * w;
      // Near 1e-17 and below, what is left of the height is rounding of the coordinates: still a cell, if not flat.
      const glm::dvec3 center = centerOf(p);
      ASSERT_TRUE(std::isfinite(glm::length(center))) << height << ", " << i;
      if (orientationSign(p[0], p[1], p[2], p[3]) == 0) continue;
      ASSERT_LE(largestDeviation(p, center), tolerance(p, center)) << height << ", " << i;
    }
  }
}

TEST(Circumcenter, ScalesWithTheMesh) {
  for (std::uint64_t i = 0; i < 100; i++) {
    const Corners p = randomCorners(4, i);
    const glm::dvec3 center = centerOf(p);
    for (const double scale : {0x1p-300, 0x1p-20, 0x1p300}) {
      Corners scaled = p;
      for (glm::dvec3& corner : scaled) corner *= scale;
      EXPECT_EQ(centerOf(scaled), scale * center) << scale;
    }
  }
}

TEST(Circumcenter, OfCellsWithoutVolumeIsTheCentroid) {
  // in a plane, in a line, with a repeated vertex, all in one point
  EXPECT_EQ(centerOf({glm::dvec3(1, 1, 1), {5, 1, 1}, {1, 5, 1}, {5, 5, 1}}), glm::dvec3(2, 2, 0));
  EXPECT_EQ(centerOf({glm::dvec3(0, 0, 0), {1, 2, 3}, {2, 4, 6}, {5, 10, 15}}), glm::dvec3(2, 4, 6));
  EXPECT_EQ(centerOf({glm::dvec3(1, 0, 0), {1, 0, 0}, {1, 4, 0}, {1, 0, 4}}), glm::dvec3(0, 1, 1));
  EXPECT_EQ(centerOf({glm::dvec3(3), glm::dvec3(3), glm::dvec3(3), glm::dvec3(3)}), glm::dvec3(0));
}

TEST(Circumcenters, AreRelativeToTheVertexOfLowestIndexWhateverTheOrderInTheFile) {
  TetMesh mesh = test::tilted(randomDelaunay(500, 1));
  const std::vector<glm::dvec3> centers = circumcenters(mesh);
  ASSERT_EQ(centers.size(), mesh.cellCount());
  for (size_t i = 0; i < mesh.cellCount(); i++) {
    const CellVertices v = sortedVertices(mesh.cells[i]);
    const Corners p = {mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])};
    ASSERT_LE(largestDeviation(p, centers[i]), tolerance(p, centers[i])) << i;
  }
  for (CellVertices& cell : mesh.cells) std::reverse(cell.begin(), cell.end());
  EXPECT_EQ(circumcenters(mesh), centers) << "to the last bit";
}

}  // namespace
}  // namespace tetralux
