// Reading and writing mesh files.
#pragma once

#include <filesystem>

#include "mesh/tet_mesh.h"

namespace tetralux {

// Reads a mesh of tetrahedra; the format is chosen by the file's name: .vtu (VTK XML unstructured grid) or .vtk (VTK
// legacy, DATASET UNSTRUCTURED_GRID, versions up to 5). The result has at least one cell and satisfies validate().
// Arrays of strings and bits are left out with a warning, as are field data that belong to neither points nor cells.
// Throws Error(Input): one line with the file, the place in it, the value found and the value expected. A damaged file
// takes no more memory than its bytes can stand for.
TetMesh readMesh(const std::filesystem::path& path);

// One format each, whatever the file's name.
TetMesh readVtu(const std::filesystem::path& path);
TetMesh readLegacyVtk(const std::filesystem::path& path);

// How a .vtu file is written.
struct VtuWriteOptions {
  bool compress = true;  // zlib in blocks of 32 KiB; otherwise raw numbers
};

// Writes all points, cells and arrays as VTU (appended raw data, UInt64 headers), complete or not at all. readVtu()
// gives back an equal mesh; indices take 32 bits where they fit. Needs 8 MiB beside the mesh.
// Throws Error(Output).
void writeVtu(const TetMesh& mesh, const std::filesystem::path& path, const VtuWriteOptions& options = {});

}  // namespace tetralux
