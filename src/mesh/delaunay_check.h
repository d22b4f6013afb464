// Whether a mesh looks like a Delaunay mesh.
#pragma once

#include <cstddef>

#include "mesh/adjacency.h"

namespace tetralux {

// Looks at the neighbours of some cells, evenly spread over the list: false if one of them has a vertex inside the
// cell's circumsphere. A mesh that passes is Delaunay, locally, at all but few places; it takes a check to know about
// those.
//   samples   cells looked at, all if there are fewer
bool looksDelaunay(const TetMesh& mesh, const Adjacency& adjacency, size_t samples);

}  // namespace tetralux
