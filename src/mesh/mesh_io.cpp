#include "mesh/mesh_io.h"

#include "base/error.h"
#include "mesh/vtk_text.h"

namespace tetralux {

TetMesh readMesh(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  const std::string lower = lowerCase(extension);
  if (lower == ".vtu") return readVtu(path);
  if (lower == ".vtk") return readLegacyVtk(path);
  fail(ErrorCode::Input, "{}: file name ends in '{}', expected .vtu or .vtk", path.string(), extension);
}

}  // namespace tetralux
