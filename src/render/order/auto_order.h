// Order "auto": no more than the view needs.
#pragma once

#include "render/order/cell_order.h"
#include "render/order/exact_order.h"
#include "render/order/key_order.h"
#include "render/order/order_check.h"

namespace tetralux::render {

// Tries orders from the cheapest on and takes the first that the check proves exact for the view.
class AutoOrder : public CellOrder {
 public:
  //   keyed   orders to try, cheapest first
  //   kit     must outlive the order
  AutoOrder(const gpu::Context& context, std::vector<std::unique_ptr<KeyOrder>> keyed, VisibilityKit& kit,
            SortVariant variant);

  CellSequence record(const OrderInputs& inputs) override;
  std::uint64_t sizeBytes() const override;

 private:
  std::vector<std::unique_ptr<KeyOrder>> keyed_;
  ExactOrder exact_;
};

}  // namespace tetralux::render
