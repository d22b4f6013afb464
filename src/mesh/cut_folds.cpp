#include "mesh/cut_folds.h"

#include "mesh/vertex_buckets.h"

namespace tetralux {

void cutFolds(const TetMesh& mesh, Adjacency& adjacency) {
  if (adjacency.foldedFaces == 0) return;
  for (std::uint32_t cell = 0; cell < mesh.cellCount(); cell++) {
    std::uint8_t& sides = adjacency.sides[cell];
    const CellVertices v = sortedVertices(mesh.cells[cell]);
    for (std::uint32_t k = 0; k < 4; k++) {
      if ((sides >> (4 + k) & 1) == 0) continue;
      adjacency.neighbors[cell][k] = kNoCell;  // the other cell has the same bit and drops this one itself
      BoundaryFace face{{v[k == 0 ? 1 : 0], v[k <= 1 ? 2 : 1], v[k <= 2 ? 3 : 2]}, cell};
      if ((sides >> k & 1) != 0) std::swap(face.vertices[1], face.vertices[2]);  // its normal pointed at the cell
      adjacency.boundary.push_back(face);
    }
    sides &= 0x0f;
  }
  adjacency.foldedFaces = 0;
}

}  // namespace tetralux
