#include "mesh/grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/check.h"
#include "mesh_checks.h"

namespace tetralux {
namespace {

using test::inSteps;
using test::topologyOf;

double sumOfSquares(const glm::dvec3& p) { return p.x * p.x + p.y * p.y + p.z * p.z; }

double cellVolume(const TetMesh& mesh, const CellVertices& v) {
  const glm::dvec3 a = mesh.point(v[0]);
  const glm::dvec3 b = mesh.point(v[1]) - a;
  const glm::dvec3 c = mesh.point(v[2]) - a;
  const glm::dvec3 d = mesh.point(v[3]) - a;
  return (b.x * (c.y * d.z - c.z * d.y) + b.y * (c.z * d.x - c.x * d.z) + b.z * (c.x * d.y - c.y * d.x)) / 6.0;
}

double smallestVolume(const TetMesh& mesh) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const CellVertices& cell : mesh.cells) smallest = std::min(smallest, cellVolume(mesh, cell));
  return smallest;
}

TEST(KuhnGrid, FillsItsBoxWithMatchingPositiveCells) {
  const TetMesh mesh = kuhnGrid(3, 4, 5, {-1, 0, 2}, {2, 2, 7}, sumOfSquares);
  EXPECT_EQ(mesh.pointCount(), 4u * 5u * 6u);
  EXPECT_EQ(mesh.cellCount(), 6u * 3u * 4u * 5u);
  const test::Topology topology = topologyOf(inSteps(mesh, 0.5));
  EXPECT_TRUE(topology.isBall());
  EXPECT_EQ(topology.border.size(), 4u * (3 * 4 + 4 * 5 + 5 * 3));
  EXPECT_TRUE(topology.volume6 == 6 * 3 * 2 * 5 * 8);
  for (const CellVertices& cell : mesh.cells) EXPECT_DOUBLE_EQ(cellVolume(mesh, cell), 3.0 * 2.0 * 5.0 / 360.0);
}

TEST(KuhnGrid, OneBoxIsSixCells) {
  const TetMesh mesh = kuhnGrid(1, 1, 1, {0, 0, 0}, {1, 1, 1}, sumOfSquares);
  EXPECT_EQ(mesh.cellCount(), 6u);
  EXPECT_TRUE(topologyOf(inSteps(mesh, 1.0)).isBall());
}

TEST(KuhnGrid, BoundsAreExactlyThoseAskedFor) {
  const glm::dvec3 low(0.1, -0.7, 1e6);
  const glm::dvec3 high(0.3, 0.2, 1e6 + 1.0 / 3.0);
  const Bounds bounds = kuhnGrid(7, 3, 11, low, high, sumOfSquares).bounds();
  EXPECT_EQ(bounds.low, low);
  EXPECT_EQ(bounds.high, high);
}

TEST(KuhnGrid, FieldIsTheFunctionAtEveryPointAndPreferred) {
  const TetMesh mesh = kuhnGrid(9, 8, 7, {0, 0, 0}, {1, 2, 3}, sumOfSquares, "square");
  EXPECT_EQ(mesh.preferredField, "square");
  EXPECT_NO_THROW(validate(mesh, "grid"));
  const ScalarField field = scalarField(mesh, "square", "grid");
  for (size_t i = 0; i < mesh.pointCount(); i++) ASSERT_EQ(field.values[i], sumOfSquares(mesh.point(i)));
}

TEST(KuhnGrid, RefusesMorePointsThanAnIndexCounts) {
  EXPECT_THROW(kuhnGrid(70000, 70000, 1, {0, 0, 0}, {1, 1, 1}, sumOfSquares), CheckFailure);
  EXPECT_THROW(kuhnGrid(2000, 2000, 2000, {0, 0, 0}, {1, 1, 1}, sumOfSquares), CheckFailure);
}

TEST(KuhnGrid, RefusesAnEmptyBox) {
  EXPECT_THROW(kuhnGrid(0, 1, 1, {0, 0, 0}, {1, 1, 1}, sumOfSquares), CheckFailure);
  EXPECT_THROW(kuhnGrid(1, 1, 1, {0, 0, 0}, {1, 0, 1}, sumOfSquares), CheckFailure);
}

TEST(JitteredGrid, KeepsAllCellsPositiveUpToTheStatedJitter) {
  for (std::uint32_t seed = 0; seed < 20; seed++)
    EXPECT_GT(smallestVolume(jitteredGrid(8, 9, 10, {0, 0, 0}, {1, 2, 3}, 0.1666, seed, waveField)), 0.0);
}

TEST(JitteredGrid, MovesInnerPointsByAtMostTheJitterAndLeavesTheBorder) {
  const TetMesh even = kuhnGrid(6, 5, 4, {0, 0, 0}, {6, 5, 4}, waveField);
  const TetMesh mesh = jitteredGrid(6, 5, 4, {0, 0, 0}, {6, 5, 4}, 0.1, 1, waveField);
  EXPECT_EQ(mesh.cells, even.cells);
  size_t moved = 0;
  for (size_t i = 0; i < mesh.pointCount(); i++) {
    const glm::dvec3 p = even.point(i);
    const glm::dvec3 move = mesh.point(i) - p;
    const bool inner = p.x > 0 && p.x < 6 && p.y > 0 && p.y < 5 && p.z > 0 && p.z < 4;
    if (!inner) {
      EXPECT_EQ(move, glm::dvec3(0.0));
    }
    for (int axis = 0; axis < 3; axis++) EXPECT_LE(std::abs(move[axis]), 0.1);
    moved += move != glm::dvec3(0.0);
  }
  EXPECT_EQ(moved, 5u * 4u * 3u);
}

TEST(JitteredGrid, SeedDecidesTheMesh) {
  const auto points = [](std::uint32_t seed) {
    return std::get<1>(jitteredGrid(5, 5, 5, {0, 0, 0}, {1, 1, 1}, 0.1, seed, waveField).points);
  };
  EXPECT_EQ(points(3), points(3));
  EXPECT_NE(points(3), points(4));
}

TEST(JitteredGrid, OneLayerHasNoInnerPoint) {
  const TetMesh mesh = jitteredGrid(4, 4, 1, {0, 0, 0}, {4, 4, 1}, 0.1, 1, waveField);
  EXPECT_EQ(std::get<1>(mesh.points), std::get<1>(kuhnGrid(4, 4, 1, {0, 0, 0}, {4, 4, 1}, waveField).points));
}

TEST(GradedBox, EdgesSpanTheRatioAndCellsStayPositive) {
  for (const double ratio : {1.0, 10.0, 1e5}) {
    constexpr std::uint32_t kBoxes = 12;
    const TetMesh mesh = gradedBox(kBoxes, ratio);
    EXPECT_EQ(mesh.bounds().low, glm::dvec3(0.0));
    EXPECT_EQ(mesh.bounds().high, glm::dvec3(1.0));
    EXPECT_GT(smallestVolume(mesh), 0.0);
    const double first = mesh.point(1).x - mesh.point(0).x;
    const double last = mesh.point(kBoxes).x - mesh.point(kBoxes - 1).x;
    EXPECT_NEAR(last / first, ratio, 1e-9 * ratio);
    double volume = 0.0;
    for (const CellVertices& cell : mesh.cells) volume += cellVolume(mesh, cell);
    EXPECT_NEAR(volume, 1.0, 1e-12);
  }
}

TEST(AddPointField, WorksOnSinglePrecisionPoints) {
  TetMesh mesh;
  mesh.points = std::vector<glm::vec3>{{0, 0, 0}, {0.1f, 0, 0}};
  addPointField(mesh, "square", sumOfSquares);
  EXPECT_EQ(mesh.pointArrays.at(0).value(1), static_cast<double>(0.1f) * static_cast<double>(0.1f));
}

TEST(DistanceField, IsTheDistanceFromItsCenter) {
  const FieldFunction field = distanceField({1, 2, 3});
  EXPECT_EQ(field({1, 2, 3}), 0.0);
  EXPECT_EQ(field({4, 6, 15}), 13.0);
}

TEST(WaveField, StaysBetweenZeroAndOne) {
  for (const TetMesh& mesh : {kuhnGrid(20, 20, 20, {-3, -3, -3}, {3, 3, 3}, waveField)}) {
    const ScalarField field = scalarField(mesh, "", "grid");
    EXPECT_GE(field.low, 0.0);
    EXPECT_LE(field.high, 1.0);
    EXPECT_GT(field.high - field.low, 0.9);
  }
}

}  // namespace
}  // namespace tetralux
