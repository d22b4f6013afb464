// Which cells share a face, and on which sides of it they lie.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux {

inline constexpr std::uint32_t kNoCell = 0xffffffffu;

// A face that does not join two cells: it has one cell, or more than two, or two cells of the same four vertices, and
// is listed once for each. Vertices are ordered so that (b - a) x (c - a) points out of the cell.
struct BoundaryFace {
  std::array<std::uint32_t, 3> vertices;
  std::uint32_t cell;
};

// Faces are numbered by the vertex that they do not have: face k of a cell is opposite its k-th vertex in ascending
// order of vertex index. The plane of a face is oriented by its own vertices in ascending order, so both cells of a
// face mean the same side when they say "positive".
struct Adjacency {
  // Cell across each face; kNoCell where there is none, where more than two cells have the face, or where the other one
  // is the same cell once more.
  std::vector<std::array<std::uint32_t, 4>> neighbors;

  // Bit k (0 to 3): the cell lies on the positive side of its face k. Bit 4 + k: the cell across face k lies on the
  // same side (the mesh is folded there, the two cells overlap). A flat cell gets the sides that its neighbours leave
  // it; cells with a repeated vertex have no neighbours.
  std::vector<std::uint8_t> sides;

  std::vector<BoundaryFace> boundary;  // by ascending cell

  // The boundary is one closed surface without a concave edge, up to 1e-9 of the mesh's size: no ray leaves the mesh
  // and comes back.
  bool isConvex = false;

  std::uint64_t foldedFaces = 0;

  size_t sizeBytes() const {
    return neighbors.size() * sizeof neighbors[0] + sides.size() + boundary.size() * sizeof boundary[0];
  }
};

// Linear in the mesh; 8 bytes per cell and 8 per point while it runs, 17 per cell in the result.
Adjacency makeAdjacency(const TetMesh& mesh);

}  // namespace tetralux
