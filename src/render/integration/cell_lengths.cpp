#include "render/integration/cell_lengths.h"

#include <algorithm>
#include <glm/vec4.hpp>

#include "gpu/commands.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

struct LengthPush {
  MeshAddresses mesh;
  std::uint32_t cellCount;
  std::uint32_t invocations;
};

// Enough to fill a device; each adds up few enough cells for single precision, and for the 65535 rounds after which
// Mesa's software device ends a loop.
constexpr std::uint32_t kLeastInvocations = 4096;
constexpr std::uint32_t kMostCells = 16384;

}  // namespace

CellLengths measureCellLengths(const gpu::Context& context, const GpuMesh& mesh, bool wideAddressing) {
  const std::uint32_t invocations = std::max(kLeastInvocations, mesh.cellCount() / kMostCells + 1);
  const gpu::Buffer parts(context, invocations * sizeof(glm::vec4), gpu::MemoryKind::Device, "cell lengths");
  ComputeVariants pipelines(context, "tables/cell_lengths.comp");
  gpu::CommandBuffer commands(context);
  commands.dispatch(pipelines.get({{SPEC_WIDE_ADDRESSING, wideAddressing}, {SPEC_CELL_FIELD, false}}),
                    {mesh.cells(), mesh.vertices(), mesh.cellScalars(), parts},
                    LengthPush{mesh.addresses(), mesh.cellCount(), invocations}, invocations);
  commands.barrier(gpu::access::kComputeWrite, gpu::access::kAnyRead | gpu::access::kHostRead);
  commands.submitAndWait();

  double longest = 0.0;
  double volume = 0.0;
  double surface = 0.0;
  for (const glm::vec4& part : gpu::downloadVector<glm::vec4>(context, parts, invocations)) {
    longest = std::max(longest, static_cast<double>(part.x));
    volume += static_cast<double>(part.y);
    surface += static_cast<double>(part.z);
  }
  CellLengths lengths;
  if (longest > 0.0) lengths.longest = static_cast<float>(longest);
  lengths.mean = volume > 0.0 ? static_cast<float>(4.0 * volume / surface) : lengths.longest;
  return lengths;
}

}  // namespace tetralux::render
