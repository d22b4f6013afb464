// Writes text of VTK's legacy format, independently of what it tests.
#pragma once

#include <string>

#include "mesh/tet_mesh.h"

namespace tetralux::test {

struct LegacyFormat {
  bool binary = false;
  bool version5 = false;                                // OFFSETS and CONNECTIVITY in place of counted cells
  bool metadata = false;                                // after every array
  ArrayValues indexType = std::vector<std::int64_t>();  // version 5
};

// Header, points and cells.
std::string legacyGrid(const TetMesh& mesh, const LegacyFormat& format);

// POINT_DATA and CELL_DATA: the active scalar as SCALARS, the others in a FIELD.
std::string legacyArrays(const TetMesh& mesh, const LegacyFormat& format);

// The whole file.
std::string buildLegacy(const TetMesh& mesh, const LegacyFormat& format);

// What follows the line that declares an array: numbers, a line's end and metadata.
std::string legacyNumbers(const ArrayValues& values, const LegacyFormat& format);

}  // namespace tetralux::test
