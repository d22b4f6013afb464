#include "reference/cell_ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace tetralux::reference {
namespace {

using Vertices = std::array<glm::dvec3, 4>;

const Vertices kUnit = {glm::dvec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Ray rayFrom(const glm::dvec3& origin, const glm::dvec3& direction) {
  return {origin, direction, glm::length(direction)};
}

// The face x = y of two cells: of a ray in it, each cell has all or nothing, and one has it.
TEST(CellRay, InTheFaceOfTwoCellsBelongsToOne) {
  const std::array<glm::dvec3, 3> face = {{{0, 0, 0}, {1, 1, 0}, {0.5, 0.5, 1}}};
  const std::array<double, 4> scalars = {0, 1, 2, 3};
  for (const bool isSwapped : {false, true}) {
    const CellGeometry a({face[0], face[1], face[2], glm::dvec3(1, 0, 0.25)}, scalars);
    const CellGeometry b({face[isSwapped ? 1 : 0], face[isSwapped ? 0 : 1], face[2], glm::dvec3(0, 1, 0.25)}, scalars);
    Ray ray;
    ray.origin = {-1.0, -1.0, 0.25};
    ray.direction = {1.0, 1.0, 0.0};
    CellSegment inA;
    CellSegment inB;
    EXPECT_NE(a.intersect(ray, inA), b.intersect(ray, inB));
  }
}

TEST(CellRay, KnownSegment) {
  const CellGeometry cell(kUnit, {0, 0, 0, 1});
  CellSegment s;
  ASSERT_TRUE(cell.intersect(rayFrom({0.25, 0.25, -2}, {0, 0, 1}), s));
  EXPECT_NEAR(s.front, 2.0, 1e-15);
  EXPECT_NEAR(s.back, 2.5, 1e-15);
  EXPECT_NEAR(s.sFront, 0.0, 1e-15);
  EXPECT_NEAR(s.sBack, 0.5, 1e-15);
}

TEST(CellRay, VertexOrderDoesNotMatter) {
  CellSegment a;
  CellSegment b;
  const Ray ray = rayFrom({0.1, 0.2, -1}, {0.1, 0.05, 1});
  ASSERT_TRUE(CellGeometry(kUnit, {1, 2, 3, 4}).intersect(ray, a));
  ASSERT_TRUE(CellGeometry({kUnit[1], kUnit[0], kUnit[2], kUnit[3]}, {2, 1, 3, 4}).intersect(ray, b));
  EXPECT_NEAR(a.front, b.front, 1e-15);
  EXPECT_NEAR(a.back, b.back, 1e-15);
  EXPECT_NEAR(a.sFront, b.sFront, 1e-15);
}

TEST(CellRay, OnlyWhatIsInFrontOfTheOriginCounts) {
  const CellGeometry cell(kUnit, {0, 0, 0, 1});
  CellSegment s;
  ASSERT_TRUE(cell.intersect(rayFrom({0.25, 0.25, 0.125}, {0, 0, 1}), s));
  EXPECT_NEAR(s.front, 0.0, 1e-15);
  EXPECT_NEAR(s.back, 0.375, 1e-15);
  EXPECT_NEAR(s.sFront, 0.125, 1e-15);
  EXPECT_FALSE(cell.intersect(rayFrom({0.25, 0.25, 2}, {0, 0, 1}), s));
}

TEST(CellRay, FlatCellsMeetNoRay) {
  const CellGeometry cell({glm::dvec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0, 1, 2, 3});
  EXPECT_TRUE(cell.empty());
}

TEST(CellRay, RaysThroughRandomInsidePointsHaveASegmentThere) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 2000; i++) {
    Vertices v;
    for (auto& p : v) p = {uniform(random), uniform(random), uniform(random)};
    const std::array<double, 4> s = {uniform(random), uniform(random), uniform(random), uniform(random)};
    std::array<double, 4> w;
    double sum = 0;
    for (double& x : w) sum += x = 0.01 + std::abs(uniform(random));
    glm::dvec3 inside(0);
    double scalar = 0;
    for (size_t k = 0; k < 4; k++) {
      inside += v[k] * (w[k] / sum);
      scalar += s[k] * w[k] / sum;
    }
    const glm::dvec3 direction(uniform(random), uniform(random), uniform(random));
    CellSegment segment;
    const CellGeometry cell(v, s);
    ASSERT_TRUE(cell.intersect(rayFrom(inside - 5.0 * direction, direction), segment));
    EXPECT_LT(segment.front, 5.0);
    EXPECT_GT(segment.back, 5.0);
    const double t = (5.0 - segment.front) / (segment.back - segment.front);
    EXPECT_NEAR(segment.sFront + t * (segment.sBack - segment.sFront), scalar, 1e-9);
  }
}

TEST(CellRay, SegmentsOfSliversAreAccurateFarFromTheOrigin) {
  // A sliver of height 1e-6 seen along its thin direction from 1000 units away.
  const double h = 1e-6;
  const glm::dvec3 offset(500, -300, 1000);
  const CellGeometry cell(
      {offset, offset + glm::dvec3(1, 0, 0), offset + glm::dvec3(0, 1, 0), offset + glm::dvec3(0.25, 0.25, h)},
      {0, 0, 0, 1});
  CellSegment s;
  ASSERT_TRUE(cell.intersect(rayFrom({500.25, -299.75, 0}, {0, 0, 1}), s));
  EXPECT_NEAR((s.back - s.front) / h, 1.0, 1e-6);
}

}  // namespace
}  // namespace tetralux::reference
