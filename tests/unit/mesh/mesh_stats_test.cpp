#include "mesh/mesh_stats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "mesh/mesh_stats_faces.h"
#include "unit/mesh/mesh_io_fixtures.h"

namespace tetralux {
namespace {

TetMesh meshOf(std::vector<glm::dvec3> points, std::vector<CellVertices> cells) {
  TetMesh mesh;
  mesh.points = std::move(points);
  mesh.cells = std::move(cells);
  return mesh;
}

TetMesh corner(double size) { return meshOf({{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}}, {{0, 1, 2, 3}}); }

TEST(MeshStats, OneCell) {
  const MeshStats stats = computeMeshStats(corner(2.0));
  EXPECT_EQ(stats.points, 4u);
  EXPECT_EQ(stats.unusedPoints, 0u);
  EXPECT_EQ(stats.cells, 1u);
  EXPECT_EQ(stats.bounds.high, glm::dvec3(2.0));
  EXPECT_EQ(stats.shortestEdge, 2.0);
  EXPECT_DOUBLE_EQ(stats.longestEdge, std::sqrt(8.0));
  EXPECT_DOUBLE_EQ(stats.totalVolume, 8.0 / 6.0);
  EXPECT_EQ(stats.zeroVolumeCells, 0u);
  EXPECT_EQ(stats.invertedCells, 0u);
  EXPECT_EQ(stats.duplicateCells, 0u);
  EXPECT_EQ(stats.boundaryFaces, 4u);
  EXPECT_EQ(stats.interiorFaces, 0u);
  EXPECT_EQ(stats.overusedFaces, 0u);
}

TEST(MeshStats, AnInvertedCellCountsItsVolume) {
  TetMesh mesh = corner(1.0);
  mesh.cells = {{0, 2, 1, 3}};
  const MeshStats stats = computeMeshStats(mesh);
  EXPECT_EQ(stats.invertedCells, 1u);
  EXPECT_DOUBLE_EQ(stats.totalVolume, 1.0 / 6.0);
}

TEST(MeshStats, ACellWithTwoVerticesInOnePlaceHasNoVolumeWhicheverTheyAre) {
  // Coordinates that rounding would not cancel.
  const glm::dvec3 p[3] = {{0.1, 0.7, 1.0 / 3.0}, {1.3, 0.9, 0.2}, {0.4, 1.1, 2.0 / 3.0}};
  for (int a = 0; a < 4; a++) {
    for (int b = a + 1; b < 4; b++) {
      std::vector<glm::dvec3> points;
      int next = 0;
      for (int i = 0; i < 4; i++) points.push_back(i == b ? points[static_cast<size_t>(a)] : p[next++]);
      const MeshStats stats = computeMeshStats(meshOf(points, {{0, 1, 2, 3}}));
      EXPECT_EQ(stats.zeroVolumeCells, 1u) << a << b;
      EXPECT_EQ(stats.repeatedVertexCells, 0u);
      EXPECT_GT(stats.shortestEdge, 0.0);
    }
  }
}

TEST(MeshStats, AFlatCellHasNoVolume) {
  const TetMesh mesh = meshOf({{0, 0, 5}, {3, 0, 5}, {0, 4, 5}, {7, 8, 5}}, {{0, 1, 2, 3}});
  const MeshStats stats = computeMeshStats(mesh);
  EXPECT_EQ(stats.zeroVolumeCells, 1u);
  EXPECT_EQ(stats.invertedCells, 0u);
}

TEST(MeshStats, ARepeatedVertexGivesAZeroVolumeAndTwoCollapsedFaces) {
  TetMesh mesh = corner(1.0);
  mesh.cells = {{0, 0, 1, 2}};
  const MeshStats stats = computeMeshStats(mesh);
  EXPECT_EQ(stats.repeatedVertexCells, 1u);
  EXPECT_EQ(stats.zeroVolumeCells, 1u);
  EXPECT_EQ(stats.unusedPoints, 1u);
  EXPECT_EQ(stats.boundaryFaces, 2u);
  EXPECT_EQ(stats.interiorFaces, 1u);
}

TEST(MeshStats, SharedFacesAndDuplicateCellsWhateverTheirOrder) {
  TetMesh mesh = corner(1.0);
  std::get<std::vector<glm::dvec3>>(mesh.points).push_back({1, 1, 1});
  mesh.cells = {{0, 1, 2, 3}, {4, 3, 2, 1}};
  MeshStats stats = computeMeshStats(mesh);
  EXPECT_EQ(stats.boundaryFaces, 6u);
  EXPECT_EQ(stats.interiorFaces, 1u);
  EXPECT_EQ(stats.duplicateCells, 0u);
  mesh.cells.push_back({3, 0, 2, 1});
  mesh.cells.push_back({1, 0, 3, 2});
  stats = computeMeshStats(mesh);
  EXPECT_EQ(stats.duplicateCells, 2u);
  EXPECT_EQ(stats.boundaryFaces, 3u);
  EXPECT_EQ(stats.interiorFaces, 0u);
  EXPECT_EQ(stats.overusedFaces, 4u);
}

TEST(MeshStats, CountsAgreeWithSetsOfFaces) {
  std::vector<CellVertices> cells;
  std::uint32_t state = 1;
  const auto next = [&] { return (state = state * 1664525u + 1013904223u) >> 8; };
  for (int i = 0; i < 5000; i++) cells.push_back({next() % 23, next() % 23, next() % 23, next() % 23});
  std::map<std::array<std::uint32_t, 3>, int> faces;
  std::set<CellVertices> different;
  for (CellVertices v : cells) {
    std::sort(v.begin(), v.end());
    different.insert(v);
    faces[{v[0], v[1], v[2]}]++;
    faces[{v[0], v[1], v[3]}]++;
    faces[{v[0], v[2], v[3]}]++;
    faces[{v[1], v[2], v[3]}]++;
  }
  FaceCounts expected;
  for (const auto& [face, count] : faces)
    (count == 1 ? expected.boundary : count == 2 ? expected.interior : expected.overused)++;
  const FaceCounts counts = countFaces(cells, 23);
  EXPECT_EQ(counts.boundary, expected.boundary);
  EXPECT_EQ(counts.interior, expected.interior);
  EXPECT_EQ(counts.overused, expected.overused);
  EXPECT_EQ(countDuplicateCells(cells, 23), cells.size() - different.size());
}

TEST(MeshStats, EdgesOfAnySizeAreMeasured) {
  for (const double size : {1e-200, 1e-30, 1e30, 1e200}) {
    const MeshStats stats = computeMeshStats(corner(size));
    EXPECT_DOUBLE_EQ(stats.shortestEdge, size);
    EXPECT_DOUBLE_EQ(stats.longestEdge, size * std::sqrt(2.0));
  }
}

TEST(MeshStats, RangesAreOverFiniteTuplesAndVectorsAreTheirLengths) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  TetMesh mesh = corner(1.0);
  mesh.pointArrays.push_back({"s", 1, std::vector<double>{-1, nan, 5, -infinity}});
  mesh.pointArrays.push_back({"v", 2, std::vector<float>{3, 4, 0, 1, INFINITY, 0, 6, 8}});
  mesh.cellArrays.push_back({"none", 1, std::vector<float>{static_cast<float>(nan)}});
  mesh.cellArrays.push_back({"i", 1, std::vector<std::int16_t>{-3}});
  const MeshStats stats = computeMeshStats(mesh);
  ASSERT_EQ(stats.arrays.size(), 4u);
  EXPECT_EQ(stats.arrays[0].low, -1.0);
  EXPECT_EQ(stats.arrays[0].high, 5.0);
  EXPECT_EQ(stats.arrays[0].nonFinite, 2u);
  EXPECT_EQ(stats.arrays[1].low, 1.0);
  EXPECT_EQ(stats.arrays[1].high, 10.0);
  EXPECT_EQ(stats.arrays[1].nonFinite, 1u);
  EXPECT_EQ(stats.arrays[1].components, 2u);
  EXPECT_EQ(stats.arrays[2].low, 0.0);
  EXPECT_EQ(stats.arrays[2].high, 0.0);
  EXPECT_EQ(stats.arrays[2].nonFinite, 1u);
  EXPECT_EQ(stats.arrays[2].association, FieldAssociation::Cell);
  EXPECT_EQ(stats.arrays[3].type, "Int16");
  EXPECT_EQ(stats.arrays[3].low, -3.0);
}

TEST(MeshStats, AMeshWithoutCellsIsAllZero) {
  const MeshStats stats = computeMeshStats(meshOf({{1, 2, 3}}, {}));
  EXPECT_EQ(stats.unusedPoints, 1u);
  EXPECT_EQ(stats.shortestEdge, 0.0);
  EXPECT_EQ(stats.longestEdge, 0.0);
  EXPECT_EQ(stats.boundaryFaces, 0u);
  EXPECT_EQ(computeMeshStats(TetMesh()).points, 0u);
}

}  // namespace
}  // namespace tetralux
