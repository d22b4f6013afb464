#include "adjacency_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "exact_sign.h"

namespace tetralux::test {
namespace {

using Face = std::array<std::uint32_t, 3>;  // ascending

struct CellFace {
  std::uint32_t cell;
  std::uint32_t face;
};

CellVertices ascending(CellVertices v) {
  std::sort(v.begin(), v.end());
  return v;
}

std::map<Face, std::vector<CellFace>> cellsOfFaces(const TetMesh& mesh) {
  std::map<Face, std::vector<CellFace>> faces;
  for (std::uint32_t cell = 0; cell < mesh.cellCount(); cell++) {
    const CellVertices v = ascending(mesh.cells[cell]);
    if (std::adjacent_find(v.begin(), v.end()) != v.end()) continue;
    faces[{v[1], v[2], v[3]}].push_back({cell, 0});
    faces[{v[0], v[2], v[3]}].push_back({cell, 1});
    faces[{v[0], v[1], v[3]}].push_back({cell, 2});
    faces[{v[0], v[1], v[2]}].push_back({cell, 3});
  }
  return faces;
}

}  // namespace

TetMesh meshOf(const std::vector<glm::dvec3>& points, const std::vector<CellVertices>& cells) {
  TetMesh mesh;
  mesh.points = points;
  mesh.cells = cells;
  return mesh;
}

int volumeSign(const TetMesh& mesh, const CellVertices& v) {
  return exactOrientation(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])).sign;
}

bool isPositive(const Adjacency& adjacency, std::uint32_t cell, std::uint32_t face) {
  return (adjacency.sides[cell] >> face & 1) != 0;
}

bool isFolded(const Adjacency& adjacency, std::uint32_t cell, std::uint32_t face) {
  return (adjacency.sides[cell] >> (4 + face) & 1) != 0;
}

void expectConsistent(const TetMesh& mesh, const Adjacency& adjacency) {
  ASSERT_EQ(adjacency.neighbors.size(), mesh.cellCount());
  ASSERT_EQ(adjacency.sides.size(), mesh.cellCount());
  std::vector<std::array<std::uint32_t, 4>> neighbors(mesh.cellCount(), {kNoCell, kNoCell, kNoCell, kNoCell});
  std::vector<std::pair<std::uint32_t, Face>> boundary;
  std::uint64_t folded = 0;
  for (const auto& [face, cells] : cellsOfFaces(mesh)) {
    // A cell that is there twice has a boundary of its own.
    const auto vertices = [&](const CellFace& one) {
      CellVertices v = mesh.cells[one.cell];
      std::sort(v.begin(), v.end());
      return v;
    };
    if (cells.size() != 2 || vertices(cells[0]) == vertices(cells[1])) {
      for (const CellFace& one : cells) boundary.emplace_back(one.cell, face);
      continue;
    }
    const auto [a, b] = std::pair(cells[0], cells[1]);
    neighbors[a.cell][a.face] = b.cell;
    neighbors[b.cell][b.face] = a.cell;
    const bool onOneSide = isPositive(adjacency, a.cell, a.face) == isPositive(adjacency, b.cell, b.face);
    EXPECT_EQ(isFolded(adjacency, a.cell, a.face), onOneSide) << "cells " << a.cell << " and " << b.cell;
    EXPECT_EQ(isFolded(adjacency, b.cell, b.face), onOneSide) << "cells " << a.cell << " and " << b.cell;
    folded += onOneSide ? 1 : 0;
  }
  EXPECT_EQ(adjacency.neighbors, neighbors);
  EXPECT_EQ(adjacency.foldedFaces, folded);

  std::vector<std::pair<std::uint32_t, Face>> listed;
  for (BoundaryFace face : adjacency.boundary) {
    std::sort(face.vertices.begin(), face.vertices.end());
    listed.emplace_back(face.cell, face.vertices);
  }
  EXPECT_TRUE(std::is_sorted(listed.begin(), listed.end(), [](auto& a, auto& b) { return a.first < b.first; }));
  std::sort(listed.begin(), listed.end());
  std::sort(boundary.begin(), boundary.end());
  EXPECT_EQ(listed, boundary);
}

}  // namespace tetralux::test
