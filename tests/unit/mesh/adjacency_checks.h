// What an Adjacency says, against the definition: by brute force and in extended precision.
#pragma once

#include <vector>

#include "mesh/adjacency.h"

namespace tetralux::test {

TetMesh meshOf(const std::vector<glm::dvec3>& points, const std::vector<CellVertices>& cells);

// Sign of (b - a) . ((c - a) x (d - a)), exactly.
int volumeSign(const TetMesh& mesh, const CellVertices& v);

// The bits of Adjacency::sides by name.
bool isPositive(const Adjacency& adjacency, std::uint32_t cell, std::uint32_t face);
bool isFolded(const Adjacency& adjacency, std::uint32_t cell, std::uint32_t face);

// Neighbours are exactly the pairs of cells that have a face of two cells, each naming the other across the same three
// vertices; what has no neighbour is the boundary; the two cells of a face say that they lie on opposite sides of it,
// or both say that it is folded. Every exact order relies on the last: one cell of a face waits and the other does not,
// or both do.
void expectConsistent(const TetMesh& mesh, const Adjacency& adjacency);

}  // namespace tetralux::test
