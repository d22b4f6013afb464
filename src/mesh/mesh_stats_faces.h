// How cells share faces, and cells that occur twice.
#pragma once

#include <cstdint>
#include <span>

#include "mesh/tet_mesh.h"
#include "mesh/vertex_buckets.h"

namespace tetralux {

struct FaceCounts {
  std::uint64_t boundary = 0;  // faces of one cell
  std::uint64_t interior = 0;  // faces of two cells
  std::uint64_t overused = 0;  // faces of more than two cells
};

// A face is three of a cell's vertices, in any order. 32 bytes per cell and 8 per point while it runs; the time is
// linear where no vertex has more than some constant number of cells.
//   cells        vertex indices below pointCount
FaceCounts countFaces(std::span<const CellVertices> cells, size_t pointCount);

// Number of cells whose vertices an earlier cell has, in any order. 12 bytes per cell and 8 per point.
std::uint64_t countDuplicateCells(std::span<const CellVertices> cells, size_t pointCount);

}  // namespace tetralux
