#include "render/order/key_order.h"

#include "base/check.h"

namespace tetralux::render {

KeyOrder::KeyOrder(const gpu::Context& context, Order order, SortRange range, SortVariant variant, OrderCheck* check)
    : order_(order), range_(range), sort_(context, variant), check_(check) {}

CellSequence KeyOrder::record(const OrderInputs& inputs) {
  CellSequence sequence = sortedSequence(inputs.sort, range_);
  sequence.report.order = order_;
  recordKeys(inputs);
  if (inputs.check) {
    CHECK(check_ != nullptr);
    check_->run(inputs, range_, {}, sequence.report);
  }
  recordSort(inputs);
  return sequence;
}

std::optional<CellSequence> KeyOrder::recordIfExact(const OrderInputs& inputs) {
  CHECK(check_ != nullptr);
  CellSequence sequence = sortedSequence(inputs.sort, range_);
  sequence.report.order = order_;
  recordKeys(inputs);
  check_->run(inputs, range_, {.onlyWhetherExact = true}, sequence.report);
  if (!sequence.report.isExact()) return std::nullopt;
  recordSort(inputs);
  return sequence;
}

void KeyOrder::recordSort(const OrderInputs& inputs) {
  gpu::CommandBuffer& commands = inputs.recorder.pass("sort");
  sort_.record(commands, inputs.sort, range_, inputs.variant.wideAddressing);
  commands.barrier(gpu::access::kComputeWrite, gpu::access::kComputeReadWrite);
}

CellSequence sortedSequence(const SortStorage& storage, SortRange range) {
  CellSequence sequence;
  sequence.order = &storage.order(range);
  sequence.orderView = &storage.orderView(range);
  sequence.kept = &storage.kept();
  return sequence;
}

}  // namespace tetralux::render
