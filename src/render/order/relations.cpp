#include "render/order/relations.h"

#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

using namespace gpu::access;

struct BoundaryPush {
  VkDeviceAddress vertices;
  VkDeviceAddress boundaryVertices;
  VkDeviceAddress boundaryCells;
  VkDeviceAddress keys;
  shared::PixelBand band;
};

struct RelatePush {
  VkDeviceAddress waiting;
  VkDeviceAddress relationHeads;
  VkDeviceAddress keys;
  shared::PixelBand band;
  std::uint32_t relationCapacity;
  std::uint32_t keyShift;
  std::uint32_t tiesAreApart;
};

struct OverlapPush {
  VkDeviceAddress waiting;
  VkDeviceAddress relationHeads;
  VkDeviceAddress keys;
  std::uint32_t relationCapacity;
  std::uint32_t pairCount;
};

}  // namespace

Relations::Relations(const gpu::Context& context)
    : context_(context),
      boundaryVertex_(loadShader(context, "order/boundary.vert")),
      boundaryFragment_(loadShader(context, "order/boundary.frag")),
      relate_(context, "order/relate.comp"),
      overlap_(context, "order/overlap.comp"),
      unused_(context, 32, gpu::MemoryKind::Device, "unused"),
      unusedView_(context, unused_, VK_FORMAT_R32_UINT) {}

void Relations::prepareLists(ImageSize size) {
  if (lists_ && lists_->size().width == size.width && lists_->size().height == size.height) return;
  lists_.reset();
  lists_ = std::make_unique<PixelLists>(context_, size, /*withColors=*/false);
}

void Relations::recordBoundary(gpu::CommandBuffer& commands, const OrderInputs& inputs, const GpuTopology& topology,
                               const shared::PixelBand& band) {
  const std::pair key{inputs.variant.perspective, inputs.variant.wideAddressing};
  if (!boundary_.contains(key)) {
    boundary_.emplace(key, gpu::GraphicsPipeline(context_, boundaryVertex_, boundaryFragment_, {},
                                                 {{SPEC_PERSPECTIVE, inputs.variant.perspective},
                                                  {SPEC_WIDE_ADDRESSING, inputs.variant.wideAddressing}}));
  }
  lists_->recordClearLists(commands);
  commands.barrier(kTransferWrite | kComputeWrite, kVertexRead | kFragmentReadWrite | kComputeReadWrite);
  const BoundaryPush push{inputs.mesh.addresses().vertices, topology.boundaryVertexAddress(),
                          topology.boundaryCellAddress(), inputs.sort.keys().address(), band};
  commands.beginRendering(band.width, lists_->size().height, {band.firstRow, band.rowCount});
  commands.draw(boundary_.at(key),
                {inputs.view, inputs.mesh.vertices(), topology.boundaryVertices(), topology.boundaryCells(),
                 inputs.sort.keyView(), lists_->heads(), lists_->links(), lists_->ranks(), lists_->counts()},
                push, 3 * topology.boundaryCount());
  commands.endRendering();
  commands.barrier(kVertexRead | kFragmentReadWrite, kComputeReadWrite);
}

void Relations::recordAdd(const OrderInputs& inputs, const GpuTopology& topology, const PeelStorage& peel) {
  prepareLists(inputs.size);
  gpu::CommandBuffer& commands = inputs.recorder.pass("order");
  lists_->recordClearCounts(commands);
  for (std::uint32_t i = 0; i < lists_->bandCount(); i++) {
    const shared::PixelBand band = lists_->band(i);
    recordBoundary(commands, inputs, topology, band);
    const RelatePush push{peel.waiting.address(),
                          peel.relationHeads.address(),
                          inputs.sort.keys().address(),
                          band,
                          peel.relationCapacity,
                          0,
                          0};
    commands.dispatch(relate_.get({{SPEC_WIDE_ADDRESSING, inputs.variant.wideAddressing}, {SPEC_RELATE_CHECK, 0}}),
                      {lists_->heads(), lists_->links(), lists_->ranks(), peel.waiting, peel.relationHeads,
                       peel.relations, peel.status, unusedView_, unused_},
                      push, std::uint64_t{band.width} * band.rowCount);
    commands.barrier(kComputeWrite, kComputeReadWrite);
    commands.barrier(kComputeReadWrite, kTransferWrite);
  }
}

void Relations::recordOverlaps(const OrderInputs& inputs, const GpuTopology& topology, const PeelStorage& peel) {
  gpu::CommandBuffer& commands = inputs.recorder.pass("order");
  const OverlapPush push{peel.waiting.address(), peel.relationHeads.address(), inputs.sort.keys().address(),
                         peel.relationCapacity, topology.overlapCount()};
  commands.dispatch(
      overlap_.get({{SPEC_WIDE_ADDRESSING, inputs.variant.wideAddressing}}),
      {topology.overlaps(), inputs.sort.keyView(), peel.waiting, peel.relationHeads, peel.relations, peel.status}, push,
      topology.overlapCount());
  commands.barrier(kComputeWrite, kComputeReadWrite);
}

void Relations::recordCheck(const OrderInputs& inputs, const GpuTopology& topology, SortRange range, bool tiesAreApart,
                            const gpu::Buffer& count) {
  prepareLists(inputs.size);
  gpu::CommandBuffer& commands = inputs.recorder.pass("check");
  lists_->recordClearCounts(commands);
  for (std::uint32_t i = 0; i < lists_->bandCount(); i++) {
    const shared::PixelBand band = lists_->band(i);
    recordBoundary(commands, inputs, topology, band);
    const RelatePush push{0, 0, inputs.sort.keys().address(), band, 0, range.firstBit, tiesAreApart};
    commands.dispatch(relate_.get({{SPEC_WIDE_ADDRESSING, inputs.variant.wideAddressing}, {SPEC_RELATE_CHECK, 1}}),
                      {lists_->heads(), lists_->links(), lists_->ranks(), unused_, unused_, unused_, unused_,
                       inputs.sort.keyView(), count},
                      push, std::uint64_t{band.width} * band.rowCount);
    commands.barrier(kComputeWrite, kComputeReadWrite);
    commands.barrier(kComputeReadWrite, kTransferWrite);
  }
}

}  // namespace tetralux::render
