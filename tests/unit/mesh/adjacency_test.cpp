#include "mesh/adjacency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "adjacency_checks.h"
#include "mesh/generate.h"
#include "mesh/random.h"
#include "support/tilted.h"

namespace tetralux {
namespace {

using test::expectConsistent;
using test::isFolded;
using test::isPositive;
using test::meshOf;
using test::tilted;
using test::volumeSign;

TetMesh unitGrid(std::uint32_t n) { return kuhnGrid(n, n, n, glm::dvec3(0), glm::dvec3(1), waveField); }

// A mesh without the cells for whose middle `isGone` holds.
template <typename IsGone>
TetMesh without(TetMesh mesh, const IsGone& isGone) {
  std::erase_if(mesh.cells, [&](const CellVertices& v) {
    return isGone(0.25 * (mesh.point(v[0]) + mesh.point(v[1]) + mesh.point(v[2]) + mesh.point(v[3])));
  });
  return mesh;
}

std::vector<TetMesh> unfoldedMeshes() {
  return {unitGrid(3),
          tilted(jitteredGrid(4, 3, 2, glm::dvec3(-1e3), glm::dvec3(1e3), 0.1, 1, waveField)),
          gradedBox(5, 1e5),
          randomDelaunay(500, 1),
          tilted(randomDelaunay(500, 2)),
          flattenedDelaunay(500, 3, 1e-4),
          sliverChain(12, 0.125),
          cyclicTriple(),
          cyclicOctahedron()};
}

TEST(Adjacency, LinksTheTwoCellsOfAFaceAndPutsThemOnOppositeSides) {
  for (const TetMesh& mesh : unfoldedMeshes()) {
    const Adjacency adjacency = makeAdjacency(mesh);
    expectConsistent(mesh, adjacency);
    EXPECT_EQ(adjacency.foldedFaces, 0u);
  }
}

// Longer than what one thread takes at a time.
TEST(Adjacency, DoesNotDependOnThreads) {
  const TetMesh mesh = twistedDelaunay(20000, 1, 0.5);
  const Adjacency adjacency = makeAdjacency(mesh);
  expectConsistent(mesh, adjacency);
  for (int i = 0; i < 3; i++) {
    const Adjacency again = makeAdjacency(mesh);
    EXPECT_EQ(again.neighbors, adjacency.neighbors);
    EXPECT_EQ(again.sides, adjacency.sides);
    EXPECT_EQ(again.foldedFaces, adjacency.foldedFaces);
  }
}

TEST(Adjacency, SidesAreThoseOfTheVolumesSign) {
  for (const TetMesh& mesh : {randomDelaunay(300, 4), twistedDelaunay(300, 4, 1.0), cyclicOctahedron()}) {
    const Adjacency adjacency = makeAdjacency(mesh);
    for (std::uint32_t cell = 0; cell < mesh.cellCount(); cell++) {
      CellVertices v = mesh.cells[cell];
      std::sort(v.begin(), v.end());
      for (std::uint32_t k = 0; k < 4; k++) {
        std::vector<std::uint32_t> face(v.begin(), v.end());
        face.erase(face.begin() + k);
        EXPECT_EQ(isPositive(adjacency, cell, k), volumeSign(mesh, {face[0], face[1], face[2], v[k]}) > 0);
      }
    }
  }
}

TEST(Adjacency, DoesNotDependOnTheOrderOfACellsVertices) {
  TetMesh mesh = twistedDelaunay(200, 5, 1.0);
  const Adjacency adjacency = makeAdjacency(mesh);
  for (size_t cell = 0; cell < mesh.cellCount(); cell++) {
    for (size_t i = 0; i < 4; i++) {
      const double other = 4.0 * randomUnit(6, 4 * cell + i);
      std::swap(mesh.cells[cell][i], mesh.cells[cell][static_cast<size_t>(other)]);
    }
  }
  const Adjacency shuffled = makeAdjacency(mesh);
  EXPECT_EQ(shuffled.neighbors, adjacency.neighbors);
  EXPECT_EQ(shuffled.sides, adjacency.sides);
}

// Two cells on the same side of their face overlap, and each knows.
TEST(Adjacency, TwoCellsOnOneSideOfTheirFaceAreFolded) {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.3, 1}, {0.3, 0.2, 0.5}, {0.1, 0.1, -1}};
  const Adjacency folded = makeAdjacency(meshOf(points, {{0, 1, 2, 3}, {1, 0, 2, 4}}));
  EXPECT_EQ(folded.foldedFaces, 1u);
  EXPECT_EQ(folded.neighbors[0][3], 1u);
  EXPECT_TRUE(isFolded(folded, 0, 3));
  EXPECT_TRUE(isFolded(folded, 1, 3));
  EXPECT_EQ(isPositive(folded, 0, 3), isPositive(folded, 1, 3));
  EXPECT_EQ(makeAdjacency(meshOf(points, {{0, 1, 2, 3}, {1, 0, 2, 5}})).foldedFaces, 0u);
}

// Delaunay cells, all positive before the twist: a face is folded where one of its two cells turned over.
TEST(Adjacency, FacesOfATurnedCellAreFolded) {
  const TetMesh mesh = twistedDelaunay(1000, 1, 0.5);
  const Adjacency adjacency = makeAdjacency(mesh);
  expectConsistent(mesh, adjacency);
  std::uint64_t folded = 0;
  for (std::uint32_t cell = 0; cell < mesh.cellCount(); cell++) {
    for (std::uint32_t k = 0; k < 4; k++) {
      const std::uint32_t neighbor = adjacency.neighbors[cell][k];
      if (neighbor == kNoCell) continue;
      const bool turned = volumeSign(mesh, mesh.cells[cell]) != volumeSign(mesh, mesh.cells[neighbor]);
      EXPECT_EQ(isFolded(adjacency, cell, k), turned);
      folded += turned && cell < neighbor;
    }
  }
  EXPECT_EQ(adjacency.foldedFaces, folded);
  EXPECT_GT(folded, 71u) << "the number of cells that turned over";
}

TEST(Adjacency, FacesOfMoreThanTwoCellsHaveNoNeighbours) {
  const TetMesh mesh =
      meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.3, 1}, {0.3, 0.2, 0.5}, {0.1, 0.1, -1}, {1, 1, 1}},
             {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}, {1, 2, 3, 6}});
  const Adjacency adjacency = makeAdjacency(mesh);
  expectConsistent(mesh, adjacency);
  for (std::uint32_t cell = 0; cell < 3; cell++) EXPECT_EQ(adjacency.neighbors[cell][3], kNoCell);
  EXPECT_EQ(adjacency.neighbors[0][0], 3u) << "other faces are not touched";
  EXPECT_EQ(adjacency.foldedFaces, 0u);
  EXPECT_FALSE(adjacency.isConvex);
}

TEST(Adjacency, CellsWithARepeatedVertexAreNotThere) {
  TetMesh mesh = unitGrid(2);
  const Adjacency alone = makeAdjacency(mesh);
  const auto& cell = mesh.cells[5];
  mesh.cells.push_back({cell[0], cell[1], cell[2], cell[2]});
  mesh.cells.push_back({cell[3], cell[3], cell[3], cell[3]});
  const Adjacency adjacency = makeAdjacency(mesh);
  expectConsistent(mesh, adjacency);
  EXPECT_TRUE(std::equal(alone.neighbors.begin(), alone.neighbors.end(), adjacency.neighbors.begin()));
  EXPECT_EQ(adjacency.neighbors[48], (std::array<std::uint32_t, 4>{kNoCell, kNoCell, kNoCell, kNoCell}));
  EXPECT_EQ(adjacency.boundary.size(), alone.boundary.size());
  EXPECT_TRUE(adjacency.isConvex);
}

// A flat square between two pyramids of two cells each, which are split along different diagonals.
TEST(Adjacency, AFlatCellLiesBetweenItsNeighbours) {
  const std::vector<glm::dvec3> points{{0.1, 0.1, 0.3}, {0.7, 0.1, 0.3}, {0.7, 0.7, 0.3},
                                       {0.1, 0.7, 0.3}, {0.3, 0.3, 0.9}, {0.3, 0.3, -0.2}};
  const std::vector<CellVertices> above{{0, 1, 2, 4}, {0, 2, 3, 4}};
  const std::vector<CellVertices> below{{0, 1, 3, 5}, {1, 2, 3, 5}};
  for (const auto& neighbors : {std::vector<CellVertices>{above[0]},
                                {below[1]},
                                {above[1], below[0]},
                                {above[0], above[1], below[0], below[1]}}) {
    std::vector<CellVertices> cells = neighbors;
    cells.push_back({0, 1, 2, 3});
    const TetMesh mesh = meshOf(points, cells);
    const Adjacency adjacency = makeAdjacency(mesh);
    expectConsistent(mesh, adjacency);
    EXPECT_EQ(adjacency.foldedFaces, 0u);
  }
}

// Seven points in a plane above one cell. Only the first flat cell touches a cell that has a volume.
TEST(Adjacency, FlatCellsPassTheirSidesOn) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 7; i++) points.emplace_back(std::cos(i), std::sin(i), 0.25);
  points.emplace_back(0.1, 0.1, -1);
  const std::vector<CellVertices> flat{{3, 4, 5, 6}, {2, 3, 4, 5}, {1, 2, 3, 4}, {0, 1, 2, 3}};
  std::vector<CellVertices> cells = flat;
  cells.push_back({0, 1, 2, 7});
  const TetMesh mesh = meshOf(points, cells);
  const Adjacency adjacency = makeAdjacency(mesh);
  expectConsistent(mesh, adjacency);
  EXPECT_EQ(adjacency.neighbors[3][3], 4u);
  EXPECT_EQ(adjacency.neighbors[0][3], 1u);

  const TetMesh island = meshOf(points, flat);  // nothing to hold on to: any sides will do that agree
  expectConsistent(island, makeAdjacency(island));
}

// A cell that is there twice has two boundaries of its own, and its neighbours' faces one as well.
TEST(Adjacency, EqualCellsAreNoNeighbours) {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  const TetMesh twins = meshOf(points, {{0, 1, 2, 3}, {0, 2, 1, 3}});
  const Adjacency adjacency = makeAdjacency(twins);
  expectConsistent(twins, adjacency);
  EXPECT_EQ(adjacency.foldedFaces, 0u);
  EXPECT_EQ(adjacency.boundary.size(), 8u);
  EXPECT_FALSE(adjacency.isConvex);
  const TetMesh beside = meshOf(points, {{0, 1, 2, 3}, {0, 2, 1, 3}, {1, 2, 3, 4}});
  expectConsistent(beside, makeAdjacency(beside));
  EXPECT_EQ(makeAdjacency(beside).boundary.size(), 12u);
}

// Cells with a volume on faces of a flat cell that would have to lie on opposite sides of it: they overlap each other,
// and the flat cell cannot be right for both.
TEST(Adjacency, AFlatCellBetweenOverlappingCellsIsFolded) {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.4, 0.4, 1}, {0.5, 0.5, 0.7}};
  for (const CellVertices& other : {CellVertices{0, 1, 3, 5}, {1, 2, 3, 5}}) {
    const TetMesh mesh = meshOf(points, {{0, 1, 2, 4}, {0, 1, 2, 3}, other});
    expectConsistent(mesh, makeAdjacency(mesh));
  }
}

TEST(Adjacency, BoundaryFacesPointOutwards) {
  for (const TetMesh& mesh : unfoldedMeshes()) {
    const Adjacency adjacency = makeAdjacency(mesh);
    for (const BoundaryFace& face : adjacency.boundary) {
      const CellVertices& v = mesh.cells[face.cell];
      const auto apex = std::find_if(v.begin(), v.end(), [&](std::uint32_t i) {
        return !std::count(face.vertices.begin(), face.vertices.end(), i);
      });
      ASSERT_NE(apex, v.end());
      EXPECT_LT(volumeSign(mesh, {face.vertices[0], face.vertices[1], face.vertices[2], *apex}), 0);
    }
  }
}

TEST(Adjacency, BoundaryEnclosesTheMeshsVolume) {
  const TetMesh mesh = randomDelaunay(1000, 7);
  double volume6 = 0.0;
  for (const auto& [v, cell] : makeAdjacency(mesh).boundary)
    volume6 += glm::dot(mesh.point(v[0]), glm::cross(mesh.point(v[1]), mesh.point(v[2])));
  EXPECT_NEAR(volume6, 6.0, 1e-12);
  EXPECT_EQ(makeAdjacency(unitGrid(5)).boundary.size(), 6u * 25 * 2);
}

TEST(Adjacency, IsConvexForBoxesAndSingleCells) {
  EXPECT_TRUE(makeAdjacency(unitGrid(1)).isConvex);
  EXPECT_TRUE(makeAdjacency(unitGrid(10)).isConvex);
  EXPECT_TRUE(makeAdjacency(tilted(unitGrid(10))).isConvex) << "faces level up to rounding";
  EXPECT_TRUE(
      makeAdjacency(jitteredGrid(6, 5, 4, glm::dvec3(1e6 + 0.1), glm::dvec3(1e6 + 0.9), 0.1, 1, waveField)).isConvex);
  EXPECT_TRUE(makeAdjacency(tilted(gradedBox(6, 1e5))).isConvex);
  EXPECT_TRUE(makeAdjacency(tilted(randomDelaunay(2000, 8))).isConvex);
  EXPECT_TRUE(makeAdjacency(flattenedDelaunay(1000, 8, 1e-3)).isConvex);
  EXPECT_TRUE(makeAdjacency(cyclicOctahedron()).isConvex);
  EXPECT_TRUE(makeAdjacency(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1, 3}})).isConvex);
}

TEST(Adjacency, IsNotConvexWhereARayMayComeBack) {
  EXPECT_FALSE(makeAdjacency(sliverChain(3, 0.5)).isConvex);
  EXPECT_FALSE(makeAdjacency(cyclicTriple()).isConvex) << "three parts";
  EXPECT_FALSE(makeAdjacency(twistedDelaunay(500, 1, 0.25)).isConvex);

  const TetMesh grid = unitGrid(4);
  EXPECT_FALSE(makeAdjacency(without(grid, [](const glm::dvec3& p) { return glm::length(p - 0.5) < 0.25; })).isConvex)
      << "a hole inside";
  EXPECT_FALSE(makeAdjacency(without(grid, [](const glm::dvec3& p) { return p.x > 0.75 && p.y > 0.5; })).isConvex)
      << "an L";
  EXPECT_FALSE(makeAdjacency(without(grid, [](const glm::dvec3& p) { return p.x > 0.25 && p.x < 0.5; })).isConvex)
      << "two boxes";
  EXPECT_FALSE(makeAdjacency(without(grid, [](const glm::dvec3& p) { return (p.x > 0.5) != (p.y > 0.5); })).isConvex)
      << "two columns that share an edge";
}

TEST(Adjacency, IsNotConvexWithAnyOneInnerOrMostOuterCellsRemoved) {
  const TetMesh grid = unitGrid(3);
  const Adjacency whole = makeAdjacency(grid);
  for (size_t cell = 0; cell < grid.cellCount(); cell++) {
    const auto outerFaces = std::count(whole.neighbors[cell].begin(), whole.neighbors[cell].end(), kNoCell);
    TetMesh mesh = grid;
    mesh.cells.erase(mesh.cells.begin() + static_cast<long>(cell));
    // A corner of three faces may be cut off.
    EXPECT_EQ(makeAdjacency(mesh).isConvex, outerFaces == 3) << cell;
  }
}

TEST(Adjacency, ADentIsSeenFromAMillionthOfTheMeshOn) {
  for (const double depth : {1e-6, 1e-3, -1e-3, -1e-6}) {
    TetMesh mesh = unitGrid(4);
    auto& points = std::get<std::vector<glm::dvec3>>(mesh.points);
    const auto middle = std::find(points.begin(), points.end(), glm::dvec3(0.5, 0.5, 1));
    ASSERT_NE(middle, points.end());
    middle->z -= depth;
    EXPECT_FALSE(makeAdjacency(mesh).isConvex) << "a dent, or a bump with a dent around it";
    middle->z = 1.0 - std::copysign(1e-12, depth);
    EXPECT_TRUE(makeAdjacency(mesh).isConvex) << "rounding";
  }
}

}  // namespace
}  // namespace tetralux
