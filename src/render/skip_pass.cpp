#include "render/skip_pass.h"

#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

using namespace gpu::access;

struct MarkPush {
  MeshAddresses mesh;
  std::uint32_t cellCount;
  std::uint32_t supportCount;
};

struct FillPush {
  VkDeviceAddress across;
  std::uint32_t cellCount;
};

struct EnclosePush {
  MeshAddresses mesh;
  VkDeviceAddress across;
  VkDeviceAddress keptAcross;
  VkDeviceAddress faces;
  std::uint32_t cellCount;
};

std::uint64_t bitBytes(std::uint32_t cellCount) { return (std::uint64_t{cellCount} + 31) / 32 * 4; }

}  // namespace

SkipPass::SkipPass(const gpu::Context& context, std::uint32_t cellCount)
    : mark_(context, "skip/mark.comp"),
      fill_(context, "skip/fill.comp"),
      enclose_(context, "skip/enclose.comp"),
      shows_(context, bitBytes(cellCount), gpu::MemoryKind::Device, "cells that show"),
      kept_(context, bitBytes(cellCount), gpu::MemoryKind::Device, "cells that are kept"),
      showsView_(context, shows_, VK_FORMAT_R32_UINT),
      keptView_(context, kept_, VK_FORMAT_R32_UINT),
      counts_(context, sizeof(shared::SkipCounts), gpu::MemoryKind::Device, "skip counts"),
      hostCounts_(context, sizeof(shared::SkipCounts), gpu::MemoryKind::Readback, "skip counts on the host") {}

void SkipPass::recordMark(gpu::CommandBuffer& commands, const SkipInputs& inputs) {
  const GpuMesh& mesh = inputs.mesh;
  const std::uint32_t cells = mesh.cellCount();
  commands.fill(shows_, 0);
  commands.fill(kept_, 0);
  commands.barrier(kTransferWrite, kComputeReadWrite);
  const gpu::SpecConstant wide{SPEC_WIDE_ADDRESSING, inputs.wideAddressing};
  commands.dispatch(mark_.get({wide, {SPEC_CELL_FIELD, mesh.isCellField()}}),
                    {mesh.cells(), mesh.vertices(), mesh.cellScalars(), inputs.support, shows_},
                    MarkPush{mesh.addresses(), cells, inputs.supportCount}, cells);
  commands.barrier(kComputeWrite, kComputeRead);
  commands.dispatch(fill_.get({wide}), {inputs.whole.across(), showsView_, kept_},
                    FillPush{inputs.whole.acrossAddress(), cells}, cells);
  commands.barrier(kComputeWrite, kComputeRead);
  enclose(commands, inputs, nullptr);
  commands.barrier(kComputeWrite, kTransferRead);
  commands.copy(counts_, 0, hostCounts_, 0, sizeof(shared::SkipCounts));
  commands.barrier(kTransferWrite, kHostRead);
}

void SkipPass::recordEnclose(gpu::CommandBuffer& commands, const SkipInputs& inputs, const WalkTopology& kept) {
  const std::vector<gpu::Buffer>& from = inputs.whole.acrossBuffer().pieces();
  const std::vector<gpu::Buffer>& to = kept.acrossBuffer().pieces();
  for (size_t i = 0; i < from.size(); i++) commands.copy(from[i], 0, to[i], 0, from[i].sizeBytes());
  enclose(commands, inputs, &kept);
  commands.barrier(kComputeWrite, kComputeRead);
}

void SkipPass::enclose(gpu::CommandBuffer& commands, const SkipInputs& inputs, const WalkTopology* kept) {
  const GpuMesh& mesh = inputs.mesh;
  commands.fill(counts_, 0);
  commands.barrier(kTransferWrite, kComputeReadWrite);
  const EnclosePush push{mesh.addresses(), inputs.whole.acrossAddress(), kept ? kept->acrossAddress() : 0,
                         kept ? kept->boundaryAddress() : 0, mesh.cellCount()};
  commands.dispatch(enclose_.get({{SPEC_WIDE_ADDRESSING, inputs.wideAddressing}, {SPEC_LIST_FACES, kept != nullptr}}),
                    {inputs.whole.across(), keptView_, mesh.cells(), mesh.vertices(), mesh.cellScalars(),
                     inputs.whole.windings(), counts_},
                    push, mesh.cellCount());
}

}  // namespace tetralux::render
