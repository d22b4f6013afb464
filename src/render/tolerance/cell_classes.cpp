#include "render/tolerance/cell_classes.h"

#include <bit>

#include "gpu/commands.h"
#include "render/pipeline_variants.h"
#include "shared/cell_classes.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

struct ClassifyPush {
  MeshAddresses mesh;
  std::uint32_t cellCount;
  float limit;
};

}  // namespace

CellClasses classifyCells(const gpu::Context& context, const GpuMesh& mesh, const TransferBuffer& transfer,
                          bool wideAddressing, double limit) {
  using namespace gpu::access;
  const gpu::Buffer counts(context, sizeof(shared::CellClassCounts), gpu::MemoryKind::Device, "cell classes");
  ComputeVariants classify(context, "tolerance/classify.comp");
  gpu::CommandBuffer commands(context);
  commands.fill(counts, 0);
  commands.barrier(kTransferWrite, kComputeReadWrite);
  commands.dispatch(
      classify.get({{SPEC_WIDE_ADDRESSING, wideAddressing}, {SPEC_CELL_FIELD, mesh.isCellField()}}),
      {mesh.cells(), mesh.vertices(), mesh.cellScalars(), transfer.pieces(), transfer.pieceBins(), counts},
      ClassifyPush{mesh.addresses(), mesh.cellCount(), static_cast<float>(limit)}, mesh.cellCount());
  commands.barrier(kComputeWrite, kAnyRead | kHostRead);
  commands.submitAndWait();
  const auto found = gpu::downloadVector<shared::CellClassCounts>(context, counts, 1)[0];
  return {found.empty,
          found.average,
          found.linear,
          found.pieces,
          static_cast<double>(std::bit_cast<float>(found.worstMean)),
          static_cast<double>(std::bit_cast<float>(found.worstChange))};
}

}  // namespace tetralux::render
