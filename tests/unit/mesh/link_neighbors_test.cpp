#include "mesh/link_neighbors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <set>

#include "adjacency_checks.h"
#include "mesh/adjacency.h"
#include "mesh/generate.h"

namespace tetralux {
namespace {

using test::meshOf;

TEST(LinkNeighbors, ReportsEverySharedFaceOnce) {
  const TetMesh mesh = randomDelaunay(5000, 3);
  std::mutex mutex;
  std::set<std::pair<std::uint32_t, std::uint32_t>> links;
  const auto neighbors = linkNeighbors(mesh, [&](std::uint32_t a, std::uint32_t b) {
    const std::lock_guard lock(mutex);
    EXPECT_TRUE(links.emplace(std::minmax(a, b)).second);
  });
  size_t linked = 0;
  for (const auto& [a, b] : links) {
    EXPECT_EQ(neighbors[a / 4][a % 4], b / 4);
    EXPECT_EQ(neighbors[b / 4][b % 4], a / 4);
  }
  for (const auto& cell : neighbors) linked += 4 - static_cast<size_t>(std::count(cell.begin(), cell.end(), kNoCell));
  EXPECT_EQ(linked, 2 * links.size());
}

// One vertex in all cells: its table of faces is as long as the mesh.
TEST(LinkNeighbors, ManyCellsMayHaveOneVertex) {
  constexpr std::uint32_t kCells = 100000;
  std::vector<glm::dvec3> points{{0, 0, 1}, {0, 0, 0}};
  std::vector<CellVertices> cells;
  for (std::uint32_t i = 0; i <= kCells; i++) {
    points.emplace_back(1.0, 1e-6 * i, 0.0);
    if (i < kCells) cells.push_back({0, 1, i + 2, i + 3});
  }
  const auto neighbors = linkNeighbors(meshOf(points, cells), [](std::uint32_t, std::uint32_t) {});
  for (std::uint32_t i = 0; i < kCells; i++) {
    EXPECT_EQ(neighbors[i][2], i + 1 < kCells ? i + 1 : kNoCell);
    EXPECT_EQ(neighbors[i][3], i > 0 ? i - 1 : kNoCell);
  }
}

}  // namespace
}  // namespace tetralux
