// libFuzzer target for the readers of triangle surfaces: whatever a file holds, it is read or refused with
// Error(Input).
#include <spdlog/spdlog.h>

#include <cstdint>
#include <cstdlib>

#include "base/error.h"
#include "memory_file.h"
#include "mesh/triangle_soup.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  spdlog::set_level(spdlog::level::off);
  return 0;
}

// The first byte chooses the reader, the rest is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, size_t size) {
  if (size == 0) return 0;
  const tetralux::test::MemoryFile file(bytes + 1, size - 1);
  constexpr decltype(&tetralux::readStl) kReaders[] = {tetralux::readStl, tetralux::readPly, tetralux::readObj,
                                                       tetralux::readVtp};
  try {
    const tetralux::TriangleMesh mesh = welded(kReaders[bytes[0] % 4](file.path()));
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t point : triangle) {
        if (point >= mesh.points.size()) std::abort();
      }
    }
  } catch (const tetralux::Error& e) {
    if (e.code() != tetralux::ErrorCode::Input) std::abort();
  }
  return 0;
}
