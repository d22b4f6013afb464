#include "fields/vertex_neighbors.h"

#include <gtest/gtest.h>

#include <set>

#include "mesh/generate.h"

namespace tetralux {
namespace {

std::vector<std::uint32_t> neighborsOf(const VertexNeighbors& neighbors, size_t vertex) {
  const auto found = neighbors.of(vertex);
  return {found.begin(), found.end()};
}

TEST(VertexNeighbors, AreTheOtherVerticesOfAllCellsOnce) {
  const TetMesh mesh = randomDelaunay(6000, 1);  // more than a block of vertices
  std::vector<std::set<std::uint32_t>> expected(mesh.pointCount());
  for (const CellVertices& cell : mesh.cells) {
    for (const std::uint32_t a : cell) {
      for (const std::uint32_t b : cell) {
        if (a != b) expected[a].insert(b);
      }
    }
  }
  const VertexNeighbors neighbors(mesh);
  for (size_t v = 0; v < mesh.pointCount(); v++)
    ASSERT_EQ(neighborsOf(neighbors, v), std::vector<std::uint32_t>(expected[v].begin(), expected[v].end()));
}

TEST(VertexNeighbors, OddCellsAndLonelyVertices) {
  TetMesh mesh;
  mesh.points = std::vector<glm::dvec3>(6, glm::dvec3(0.0));
  mesh.cells = {{0, 0, 1, 4}, {1, 3, 0, 4}, {1, 3, 0, 4}};
  const VertexNeighbors neighbors(mesh);
  EXPECT_EQ(neighborsOf(neighbors, 0), (std::vector<std::uint32_t>{1, 3, 4}));
  EXPECT_TRUE(neighbors.of(2).empty());
  EXPECT_EQ(neighborsOf(neighbors, 4), (std::vector<std::uint32_t>{0, 1, 3}));
  EXPECT_TRUE(neighbors.of(5).empty());
}

TEST(VertexNeighbors, NoMeshNoNeighbors) { EXPECT_NO_THROW(VertexNeighbors{TetMesh()}); }

}  // namespace
}  // namespace tetralux
