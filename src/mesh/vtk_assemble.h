// Steps from decoded arrays to a mesh that both VTK readers share. All throw Error(Input) that begins with `place`.
#pragma once

#include <string_view>

#include "mesh/tet_mesh.h"

namespace tetralux {

// Appends x, y, z of every point. Float32 stays, every other type becomes double; so do the points before where the
// parts of a file differ.
void appendPoints(TetMesh& mesh, const ArrayValues& coordinates);

// Throws unless every cell is a tetrahedron by its type.
void checkCellTypes(const ArrayValues& types, std::string_view place);

// Throws unless every cell ends four vertices after the one before it.
//   ends   number of vertices up to and including each cell
void checkCellEnds(const ArrayValues& ends, std::string_view place);

// Appends cells of four vertices each.
//   vertices    4 x the number of cells, indices from 0
//   firstPoint  added to every index: points before this part of the file
//   pointCount  points of this part, all indices are below it
void appendCells(TetMesh& mesh, const ArrayValues& vertices, size_t firstPoint, size_t pointCount,
                 std::string_view place);

// Appends the array; one whose name is already there is left out with a warning.
void addArray(std::vector<DataArray>& arrays, DataArray&& array, std::string_view place);

// Throws where that many points cannot be indexed by 32 bits.
void checkPointCount(std::uint64_t points, std::string_view place);

}  // namespace tetralux
