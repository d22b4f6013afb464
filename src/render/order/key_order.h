// Orders that are one sort of the cells by a key.
#pragma once

#include <optional>

#include "render/order/cell_order.h"
#include "render/order/order_check.h"

namespace tetralux::render {

// Sorts by the keys' bits in a range. Of the cull pass's centroid distances, none, bucket and radix are the same sort
// of no bits, the highest 8, or all of them.
class KeyOrder : public CellOrder {
 public:
  //   check   needed where a frame asks for it, may be null otherwise; must outlive the order
  KeyOrder(const gpu::Context& context, Order order, SortRange range, SortVariant variant, OrderCheck* check);

  CellSequence record(const OrderInputs& inputs) override;
  std::uint64_t sizeBytes() const override { return 0; }

  // Records the order only if the check proves it exact; otherwise nothing, and keys may have changed.
  std::optional<CellSequence> recordIfExact(const OrderInputs& inputs);

 private:
  // Records what replaces the cull pass's keys, and a barrier. KEY_TRANSPARENT and KEY_OUTSIDE must stay.
  virtual void recordKeys(const OrderInputs&) {}
  void recordSort(const OrderInputs& inputs);

  Order order_;
  SortRange range_;
  SortPass sort_;
  OrderCheck* check_;
};

// The sequence that a sort leaves in its storage.
CellSequence sortedSequence(const SortStorage& storage, SortRange range);

}  // namespace tetralux::render
