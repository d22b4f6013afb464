// What `tetralux info` says about a mesh.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux {

// Range of one array; components of vectors are taken together as lengths.
struct ArrayStats {
  std::string name;
  std::string type;            // VTK's name of the number type
  std::uint32_t components = 1;
  FieldAssociation association = FieldAssociation::Point;
  double low = 0.0;            // over finite values
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
  double totalVolume = 0.0;   // sum of absolute volumes, world units cubed

  std::uint64_t zeroVolumeCells = 0;    // volume exactly zero in double precision (repeated vertices included)
  std::uint64_t repeatedVertexCells = 0;  // a vertex index occurs twice
  std::uint64_t invertedCells = 0;      // negative volume by VTK_TETRA's vertex order
  std::uint64_t duplicateCells = 0;     // cells whose four vertices an earlier cell has, in any order

  std::uint64_t boundaryFaces = 0;   // faces of one cell
  std::uint64_t interiorFaces = 0;   // faces of two cells
  std::uint64_t overusedFaces = 0;   // faces of more than two cells
};

// Gathers all of it; time and memory linear in the mesh (48 bytes per cell for the faces).
// Faces of cells with a repeated vertex are not counted.
MeshStats computeMeshStats(const TetMesh& mesh);

}  // namespace tetralux
