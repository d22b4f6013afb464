#include "render/order/bitonic_order.h"

#include "base/check.h"
#include "render/order/key_order.h"

namespace tetralux::render {

BitonicOrder::BitonicOrder(const gpu::Context& context, OrderCheck* check)
    : context_(context), sort_(context), check_(check) {}

CellSequence BitonicOrder::record(const OrderInputs& inputs) {
  if (!storage_) storage_ = std::make_unique<BitonicStorage>(context_, inputs.mesh.cellCount());
  CellSequence sequence = sortedSequence(inputs.sort, BitonicPass::kResult);
  sequence.report.order = Order::Bitonic;
  if (inputs.check) {
    CHECK(check_ != nullptr);
    check_->run(inputs, BitonicPass::kResult, {}, sequence.report);
  }
  gpu::CommandBuffer& commands = inputs.recorder.pass("sort");
  sort_.record(commands, inputs.sort, *storage_, inputs.variant.wideAddressing);
  commands.barrier(gpu::access::kComputeWrite, gpu::access::kComputeReadWrite);
  return sequence;
}

}  // namespace tetralux::render
