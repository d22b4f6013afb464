// What `tetralux info` says about a mesh.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux {

// Range of one array; components of a vector are taken together as its length (Euclidean norm).
struct ArrayStats {
  std::string name;
  std::string type;  // VTK's name of the number type
  std::uint32_t components = 1;
  FieldAssociation association = FieldAssociation::Point;
  double low = 0.0;  // over finite tuples; 0 where there is none
  double high = 0.0;
  std::uint64_t nonFinite = 0;  // tuples with a NaN or an infinity
};

struct MeshStats {
  std::uint64_t points = 0;
  std::uint64_t unusedPoints = 0;  // of no cell
  std::uint64_t cells = 0;
  Bounds bounds;
  std::vector<ArrayStats> arrays;

  double shortestEdge = 0.0;  // world units, zero-length edges left out
  double longestEdge = 0.0;
  double totalVolume = 0.0;  // sum of absolute volumes, world units cubed

  std::uint64_t zeroVolumeCells = 0;      // volume exactly zero in double precision: flat, or two vertices in one place
  std::uint64_t repeatedVertexCells = 0;  // a vertex index occurs twice
  std::uint64_t invertedCells = 0;        // negative volume by VTK_TETRA's vertex order
  std::uint64_t duplicateCells = 0;       // cells whose four vertices an earlier cell has, in any order

  // A face is three of a cell's vertices. A cell with a repeated vertex has four as well: two of them have that vertex
  // twice, the other two are the same face.
  std::uint64_t boundaryFaces = 0;  // of one cell
  std::uint64_t interiorFaces = 0;  // of two cells
  std::uint64_t overusedFaces = 0;  // of more than two cells
};

// Gathers all of it, on all processors; the result does not depend on their number. Time and memory are linear in the
// mesh: 32 bytes per cell and 8 per point while it runs. A volume is the determinant of three edge vectors in double
// precision; its sign is exact where rounding cannot reach it, about 1e-15 of the product of the edges' lengths.
//   mesh   satisfies validate()
MeshStats computeMeshStats(const TetMesh& mesh);

}  // namespace tetralux
