#include "render/project_pass.h"

#include "render/truth_table.h"

namespace tetralux::render {
namespace {

struct ProjectPush {
  MeshAddresses mesh;
  VkDeviceAddress order;
  std::uint32_t firstSlot;
  std::uint32_t slotCount;
};

std::vector<std::uint32_t> truthTableWords() {
  const auto table = makeTruthTable();
  return {table.begin(), table.end()};
}

}  // namespace

ProjectPass::ProjectPass(const gpu::Context& context)
    : arguments_(context, "project/batches.comp"),
      project_(context, "project/project.comp"),
      truthTable_(gpu::makeBuffer(context, truthTableWords(), "truth table")),
      truthTableView_(context, truthTable_, VK_FORMAT_R32_UINT) {}

void ProjectPass::recordArguments(gpu::CommandBuffer& commands, const gpu::Buffer& kept, const gpu::Buffer& counters,
                                  const BatchStorage& batches) {
  commands.dispatch(arguments_.get({}), {kept, counters, batches.arguments}, batches.batchCount, batches.batchCount);
}

void ProjectPass::recordBatch(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
                              const gpu::Buffer& view, const gpu::Buffer& order, const gpu::TexelView& orderView,
                              const gpu::Buffer& counters, const BatchStorage& batches, std::uint32_t batch) {
  const ProjectPush push{mesh.addresses(), order.address(), batch * shared::BATCH_CELLS, mesh.cellCount()};
  commands.dispatchIndirect(project_.get(variant.specConstants()),
                            {view, mesh.cells(), mesh.vertices(), mesh.cellScalars(), truthTableView_, orderView,
                             counters, batches.positions, batches.ends, batches.modes},
                            push, batches.arguments,
                            batch * sizeof(shared::BatchArguments) + offsetof(shared::BatchArguments, groupsX));
}

}  // namespace tetralux::render
