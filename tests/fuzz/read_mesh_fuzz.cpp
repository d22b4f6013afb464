// libFuzzer target for the readers: whatever a file holds, it is read or refused with Error(Input).
#include <spdlog/spdlog.h>

#include <cstdint>
#include <cstdlib>

#include "base/error.h"
#include "memory_file.h"
#include "mesh/mesh_io.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  spdlog::set_level(spdlog::level::off);
  return 0;
}

// Legacy files begin with '#', XML does not.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, size_t size) {
  const tetralux::test::MemoryFile file(bytes, size);
  try {
    const bool isLegacy = size > 0 && bytes[0] == '#';
    const tetralux::TetMesh mesh = isLegacy ? tetralux::readLegacyVtk(file.path()) : tetralux::readVtu(file.path());
    validate(mesh, "read mesh");
    if (mesh.cells.empty()) std::abort();
  } catch (const tetralux::Error& e) {
    if (e.code() != tetralux::ErrorCode::Input) std::abort();
  }
  return 0;
}
