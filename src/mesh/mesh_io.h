// Reading and writing mesh files.
#pragma once

#include <filesystem>

#include "mesh/tet_mesh.h"

namespace tetralux {

// Reads a mesh of tetrahedra; the format is chosen by the file's name: .vtu (VTK XML unstructured grid) or .vtk (VTK
// legacy, DATASET UNSTRUCTURED_GRID, versions 2 to 5). The result satisfies validate().
// Throws Error(Input): one line with the file, the place in it, the value found and the value expected.
TetMesh readMesh(const std::filesystem::path& path);

// One format each; `path` is used in messages only.
TetMesh readVtu(const std::filesystem::path& path);
TetMesh readLegacyVtk(const std::filesystem::path& path);

// How a .vtu file is written.
struct VtuWriteOptions {
  bool compress = true;  // zlib in blocks of 32 KiB; otherwise raw numbers
};

// Writes all points, cells and arrays as VTU (appended raw data, UInt64 headers), complete or not at all.
// Throws Error(Output).
void writeVtu(const TetMesh& mesh, const std::filesystem::path& path, const VtuWriteOptions& options = {});

}  // namespace tetralux
