#include "render/order/auto_order.h"

namespace tetralux::render {

AutoOrder::AutoOrder(const gpu::Context& context, std::vector<std::unique_ptr<KeyOrder>> keyed, VisibilityKit& kit,
                     SortVariant variant)
    : keyed_(std::move(keyed)), exact_(context, kit, variant) {}

CellSequence AutoOrder::record(const OrderInputs& inputs) {
  for (const std::unique_ptr<KeyOrder>& order : keyed_) {
    if (std::optional<CellSequence> sequence = order->recordIfExact(inputs)) return *sequence;
  }
  return exact_.record(inputs);
}

std::uint64_t AutoOrder::sizeBytes() const {
  std::uint64_t bytes = exact_.sizeBytes();
  for (const std::unique_ptr<KeyOrder>& order : keyed_) bytes += order->sizeBytes();
  return bytes;
}

}  // namespace tetralux::render
