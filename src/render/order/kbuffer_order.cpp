#include "render/order/kbuffer_order.h"

#include "base/check.h"
#include "render/order/key_order.h"

namespace tetralux::render {

KBufferOrder::KBufferOrder(const gpu::Context& context, std::uint32_t k, SortRange range, SortVariant variant,
                           OrderCheck* check)
    : k_(k), range_(range), sort_(context, variant), check_(check) {}

CellSequence KBufferOrder::record(const OrderInputs& inputs) {
  CellSequence sequence = sortedSequence(inputs.sort, range_);
  sequence.report.order = Order::KBuffer;
  sequence.kBuffer = k_;
  sequence.apart = {{0, inputs.mesh.cellCount()}};
  if (inputs.check) {
    CHECK(check_ != nullptr);
    check_->run(inputs, range_, {}, sequence.report);
  }
  gpu::CommandBuffer& commands = inputs.recorder.pass("sort");
  sort_.record(commands, inputs.sort, range_, inputs.variant.wideAddressing);
  commands.barrier(gpu::access::kComputeWrite, gpu::access::kComputeReadWrite);
  return sequence;
}

}  // namespace tetralux::render
