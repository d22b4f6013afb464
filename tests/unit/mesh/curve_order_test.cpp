#include "mesh/curve_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "mesh/generate.h"

namespace tetralux {
namespace {

// Arrays that tell which point and which cell a place belonged to, and what its corners were.
TetMesh marked(TetMesh mesh) {
  std::vector<double> pointMarks;
  for (size_t i = 0; i < mesh.pointCount(); i++) pointMarks.push_back(mesh.point(i).x + 10 * mesh.point(i).z);
  std::vector<float> cellMarks;
  for (size_t i = 0; i < mesh.cellCount(); i++) {
    cellMarks.push_back(static_cast<float>(i));
    cellMarks.push_back(-1.0f);
  }
  mesh.pointArrays.push_back({"point mark", 1, pointMarks});
  mesh.cellArrays.push_back({"cell mark", 2, cellMarks});
  return mesh;
}

// A cell as what it is: its corners, in their order, and its number before.
using Corners = std::vector<std::array<double, 3>>;

std::set<std::pair<Corners, double>> cellsOf(const TetMesh& mesh) {
  std::set<std::pair<Corners, double>> result;
  for (size_t i = 0; i < mesh.cellCount(); i++) {
    Corners corners;
    for (const std::uint32_t v : mesh.cells[i]) corners.push_back({mesh.point(v).x, mesh.point(v).y, mesh.point(v).z});
    EXPECT_EQ(mesh.cellArrays.back().value(i, 1), -1.0);
    result.insert({corners, mesh.cellArrays.back().value(i, 0)});
  }
  return result;
}

TEST(CurveOrder, ChangesNothingButTheOrder) {
  const TetMesh mesh = marked(jitteredGrid(9, 8, 7, glm::dvec3(0), glm::dvec3(1), 0.1, 3, waveField));
  for (const bool isShuffled : {false, true}) {
    TetMesh moved = mesh;
    if (isShuffled)
      shuffle(moved, 7);
    else
      orderAlongCurve(moved);
    validate(moved, "test");
    EXPECT_NE(moved.cells, mesh.cells);
    EXPECT_EQ(cellsOf(moved), cellsOf(mesh));
    for (size_t i = 0; i < moved.pointCount(); i++)
      ASSERT_EQ(moved.pointArrays.back().value(i), moved.point(i).x + 10 * moved.point(i).z);
    const ScalarField before = scalarField(mesh, "", "test");
    const ScalarField after = scalarField(moved, "", "test");
    EXPECT_EQ(std::set(before.values.begin(), before.values.end()), std::set(after.values.begin(), after.values.end()));
  }
}

TEST(CurveOrder, BringsNeighboursTogether) {
  TetMesh mesh = randomDelaunay(20000, 3, waveField);
  EXPECT_LT(memorySpread(mesh), 0.12) << "generated along the curve";
  shuffle(mesh, 5);
  EXPECT_GT(memorySpread(mesh), 0.3);
  orderAlongCurve(mesh);
  EXPECT_LT(memorySpread(mesh), 0.12);
  const TetMesh grid = kuhnGrid(20, 20, 20, glm::dvec3(0), glm::dvec3(1), waveField);
  EXPECT_LT(memorySpread(grid), 0.08);
  // Cells alone in random order are as far apart.
  TetMesh cells = randomDelaunay(20000, 3, waveField);
  for (size_t i = 0; i < cells.cellCount() / 2; i += 2)
    std::swap(cells.cells[i], cells.cells[cells.cellCount() - 1 - i]);
  EXPECT_GT(memorySpread(cells), 0.2);
}

TEST(CurveOrder, TakesMeshesOfAllSizes) {
  TetMesh empty;
  EXPECT_EQ(memorySpread(empty), 0.0);
  orderAlongCurve(empty);
  TetMesh flat;  // all points at one place
  flat.points = std::vector<glm::vec3>(4, {1, 2, 3});
  flat.cells = {{3, 1, 2, 0}};
  orderAlongCurve(flat);
  EXPECT_EQ(flat.cells[0], (CellVertices{3, 1, 2, 0})) << "ties keep their order";
  TetMesh one = cyclicTriple();
  orderAlongCurve(one);
  validate(one, "test");
}

}  // namespace
}  // namespace tetralux
