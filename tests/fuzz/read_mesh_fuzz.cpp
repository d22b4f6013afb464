// libFuzzer target for the readers: whatever a file holds, it is read or refused with Error(Input).
#include <spdlog/spdlog.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "base/error.h"
#include "mesh/mesh_io.h"

namespace {

// A file in memory, by a path that the readers can open.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* bytes, size_t size) : descriptor_(memfd_create("mesh", 0)) {
    if (descriptor_ < 0 || ::write(descriptor_, bytes, size) != static_cast<ssize_t>(size)) std::abort();
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  spdlog::set_level(spdlog::level::off);
  return 0;
}

// Legacy files begin with '#', XML does not.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, size_t size) {
  const MemoryFile file(bytes, size);
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
