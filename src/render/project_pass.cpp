#include "render/project_pass.h"

#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

struct ProjectPush {
  MeshAddresses mesh;
  VkDeviceAddress order;
  std::uint32_t firstSlot;
  std::uint32_t endSlot;
  std::uint32_t isCounted;
};

}  // namespace

ProjectPass::ProjectPass(const gpu::Context& context)
    : arguments_(context, "project/batch.comp"), project_(context, "project/project.comp") {}

void ProjectPass::recordArguments(gpu::CommandBuffer& commands, const FrameVariant& variant,
                                  const CellSequence& sequence, SlotSpan slots, const gpu::Buffer& counters,
                                  const BatchStorage& batches) {
  using namespace gpu::access;
  commands.dispatch(arguments_.get({{SPEC_SILHOUETTE, variant.silhouette}}),
                    {*sequence.kept, counters, batches.arguments}, slots, 1);
  commands.barrier(kComputeWrite, kIndirectRead | kComputeReadWrite | kVertexRead);
}

void ProjectPass::recordBatch(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
                              const TransferBuffer& transfer, const GpuTruthTable& truthTable, const gpu::Buffer& view,
                              const CellSequence& sequence, SlotSpan slots, const gpu::Buffer& counters,
                              const BatchStorage& batches, bool isCounted) {
  using namespace gpu::access;
  recordArguments(commands, variant, sequence, slots, counters, batches);
  const ProjectPush push{mesh.addresses(), sequence.order->address(), slots.first, slots.end, isCounted};
  commands.dispatchIndirect(
      project_.get(variant.specConstants()),
      {view, mesh.cells(), mesh.vertices(), mesh.cellScalars(), truthTable.view, *sequence.orderView, counters,
       batches.positions, batches.ends, batches.modes, transfer.largestExtinction()},
      push, batches.arguments, offsetof(shared::BatchArguments, groupsX));
  commands.barrier(kComputeWrite, kVertexRead | kComputeReadWrite);
}

}  // namespace tetralux::render
