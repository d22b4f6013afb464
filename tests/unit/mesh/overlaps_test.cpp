#include "mesh/overlaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include "adjacency_checks.h"
#include "mesh/generate.h"
#include "support/tilted.h"

namespace tetralux {
namespace {

using test::meshOf;
using Pairs = std::vector<std::array<std::uint32_t, 2>>;

Pairs overlapsOf(const TetMesh& mesh) { return findOverlaps(mesh, makeAdjacency(mesh)); }

// Whether a point is inside a cell, clearly.
bool holds(const TetMesh& mesh, std::uint32_t cell, const glm::dvec3& p) {
  std::array<glm::dvec3, 4> v;
  for (size_t i = 0; i < 4; i++) v[i] = mesh.point(mesh.cells[cell][i]);
  const auto volume = [](const auto& a, const auto& b, const auto& c, const auto& d) {
    return glm::dot(glm::cross(b - a, c - a), d - a);
  };
  const double whole = volume(v[0], v[1], v[2], v[3]);
  if (whole == 0.0) return false;
  for (size_t i = 0; i < 4; i++) {
    auto w = v;
    w[i] = p;
    if (volume(w[0], w[1], w[2], w[3]) / whole < 1e-6) return false;
  }
  return true;
}

TEST(Overlaps, MeshesWithoutFoldsHaveNone) {
  EXPECT_TRUE(overlapsOf(randomDelaunay(500, 1)).empty());
  EXPECT_TRUE(overlapsOf(gradedBox(5, 1e4)).empty());
  EXPECT_TRUE(overlapsOf(cyclicOctahedron()).empty());
}

// Two cells on one side of their common face; a third one beyond the face, and a fourth away from all.
TEST(Overlaps, FindsCellsOnOneSideOfTheirFace) {
  const TetMesh mesh =
      meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.3, 0.3, 0.7}, {2, 2, 2}, {3, 2, 2}, {2, 3, 2}, {2, 2, 3}},
             {{0, 1, 2, 3}, {0, 1, 2, 4}, {5, 6, 7, 8}});
  EXPECT_EQ(overlapsOf(mesh), (Pairs{{0, 1}}));
}

// Parts that share no face: one inside the other's cell, one twice, one that only touches.
TEST(Overlaps, FindsPartsThatPenetrate) {
  const TetMesh mesh = meshOf({{0, 0, 0},
                               {1, 0, 0},
                               {0, 1, 0},
                               {0, 0, 1},
                               {0.1, 0.1, 0.1},
                               {0.2, 0.1, 0.1},
                               {0.1, 0.2, 0.1},
                               {0.1, 0.1, 0.2},
                               {-1, 0, 0},
                               {0, -1, 0},
                               {0, 0, -1}},
                              {{0, 1, 2, 3}, {4, 5, 6, 7}, {3, 1, 0, 2}, {0, 8, 9, 10}});
  EXPECT_EQ(overlapsOf(mesh), (Pairs{{0, 1}, {0, 2}, {1, 2}}));
}

// Points at random inside two cells find no pair that is missing.
TEST(Overlaps, OfATwistedColumnAreThoseThatPointsAtRandomFind) {
  const TetMesh mesh = test::tilted(twistedDelaunay(300, 1, 1.5));
  const Pairs pairs = overlapsOf(mesh);
  ASSERT_FALSE(pairs.empty());
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
  const Bounds bounds = mesh.bounds();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  size_t shared = 0;
  size_t found = 0;
  for (int i = 0; i < 3000; i++) {
    const glm::dvec3 p =
        bounds.low + (bounds.high - bounds.low) * glm::dvec3(uniform(random), uniform(random), uniform(random));
    std::vector<std::uint32_t> holders;
    for (std::uint32_t cell = 0; cell < mesh.cellCount(); cell++) {
      if (holds(mesh, cell, p)) holders.push_back(cell);
    }
    if (holders.size() < 2) continue;
    shared++;
    bool isKnown = false;
    for (size_t a = 0; a < holders.size(); a++) {
      for (size_t b = a + 1; b < holders.size(); b++)
        isKnown = isKnown || std::binary_search(pairs.begin(), pairs.end(), std::array{holders[a], holders[b]});
    }
    if (isKnown) found++;
  }
  EXPECT_GT(shared, 50u);
  // The column's outer surface passes through itself, too, and there none of two layers is turned over.
  EXPECT_GE(found * 10, shared * 8);
}

TEST(Overlaps, NeighboursOnlyTouch) {
  // A fold somewhere makes the search happen; the grid beside it is clean.
  TetMesh mesh = kuhnGrid(3, 3, 3, glm::dvec3(0), glm::dvec3(1), waveField);
  auto& points = std::get<std::vector<glm::dvec3>>(mesh.points);
  const auto n = static_cast<std::uint32_t>(points.size());
  points.insert(points.end(), {{5, 5, 5}, {6, 5, 5}, {5, 6, 5}, {5, 5, 6}, {5.3, 5.3, 5.7}});
  const auto first = static_cast<std::uint32_t>(mesh.cellCount());
  mesh.cells.push_back({n, n + 1, n + 2, n + 3});
  mesh.cells.push_back({n, n + 1, n + 2, n + 4});
  mesh.pointArrays.clear();
  EXPECT_EQ(overlapsOf(mesh), (Pairs{{first, first + 1}}));
}

}  // namespace
}  // namespace tetralux
