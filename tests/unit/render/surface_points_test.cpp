#include "render/surface_points.h"

#include <gtest/gtest.h>

namespace tetralux::render {
namespace {

using glm::vec2;
using glm::vec4;

// Points at -1e30, 0, 1 and 1 (a step), 1e30.
const std::vector<vec4> kPoints = {vec4(0), vec4(0), vec4(1), vec4(3), vec4(3)};
const std::vector<vec2> kScalars = {{-1e30f, 0.0f}, {0.0f, 1.0f}, {1.0f, 1.0f}, {1.0f, 1e30f}};

std::vector<int> surfacesOf(const SurfacePoints& points) {
  std::vector<int> result;
  for (const vec4& s : points.scalars) result.push_back(static_cast<int>(s.z));
  result.push_back(static_cast<int>(points.scalars.back().w));
  return result;
}

TEST(SurfacePoints, NoIsovaluesLeavePointsAlone) {
  const SurfacePoints points = insertIsovalues(kPoints, kScalars, {});
  EXPECT_EQ(points.points, kPoints);
  EXPECT_EQ(surfacesOf(points), (std::vector<int>{-1, -1, -1, -1, -1}));
}

TEST(SurfacePoints, AnIsovalueIsAPointOfTheSameFunction) {
  const SurfacePoints points = insertIsovalues(kPoints, kScalars, {0.25f, 5.0f});
  ASSERT_EQ(points.points.size(), 7u);
  EXPECT_EQ(points.points[2], vec4(0.25f));
  EXPECT_EQ(points.points[5], vec4(3.0f));
  EXPECT_EQ(surfacesOf(points), (std::vector<int>{-1, -1, 0, -1, -1, 1, -1}));
  for (size_t i = 0; i + 1 < points.scalars.size(); i++) {
    EXPECT_LE(points.scalars[i].x, points.scalars[i].y);
    EXPECT_EQ(points.scalars[i].y, points.scalars[i + 1].x);
    EXPECT_EQ(points.scalars[i].w, points.scalars[i + 1].z);
  }
}

// One of a step's two points, so that the surface is met once from either side.
TEST(SurfacePoints, OnAStepOneOfItsPointsIsTheSurface) {
  const SurfacePoints points = insertIsovalues(kPoints, kScalars, {1.0f});
  EXPECT_EQ(points.points, kPoints);
  EXPECT_EQ(surfacesOf(points), (std::vector<int>{-1, -1, 0, -1, -1}));
}

// Isovalues that single precision cannot tell apart are two surfaces at one place.
TEST(SurfacePoints, EqualIsovaluesAreSurfacesOneAfterTheOther) {
  const SurfacePoints points = insertIsovalues(kPoints, kScalars, {0.5f, 0.5f});
  EXPECT_EQ(surfacesOf(points), (std::vector<int>{-1, -1, 0, 1, -1, -1, -1}));
  EXPECT_EQ(points.points[2], points.points[3]);
}

}  // namespace
}  // namespace tetralux::render
