// Meshes are cut open where they are folded, so that every way through the adjacency goes straight on.
#pragma once

#include "mesh/adjacency.h"

namespace tetralux {

// Turns every face whose two cells lie on the same side of it (they overlap) into two boundary faces. Afterwards no bit
// of Adjacency::sides says "folded", foldedFaces is 0, and all cells that are still connected have consistent
// orientations: a line that crosses a part of the mesh enters it as often as it leaves it, and walks through each cell
// once.
//   mesh   that the adjacency was made from
void cutFolds(const TetMesh& mesh, Adjacency& adjacency);

}  // namespace tetralux
