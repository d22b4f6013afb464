// The order by centroid distance, sorted as Marroquim et al. 2008 do.
#pragma once

#include "render/bitonic_pass.h"
#include "render/order/cell_order.h"
#include "render/order/order_check.h"

namespace tetralux::render {

// A bitonic merge sort of the cull pass's keys: the same sequence as Order::Radix, reached in n log^2 n exchanges.
class BitonicOrder : public CellOrder {
 public:
  //   check   needed where a frame asks for it, may be null otherwise; must outlive the order
  BitonicOrder(const gpu::Context& context, OrderCheck* check);

  CellSequence record(const OrderInputs& inputs) override;
  std::uint64_t sizeBytes() const override { return storage_ ? storage_->sizeBytes() : 0; }

 private:
  const gpu::Context& context_;
  BitonicPass sort_;
  OrderCheck* check_;
  std::unique_ptr<BitonicStorage> storage_;  // made when first needed
};

}  // namespace tetralux::render
