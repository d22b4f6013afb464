// The visibility order itself.
#pragma once

#include "render/order/cell_order.h"
#include "render/order/order_check.h"
#include "render/peel_pass.h"

namespace tetralux::render {

// Peels cells from the back (PeelPass), across shared faces and across gaps, and sorts them by their level. What cycles
// keep from being peeled is resolved on the host (resolveCycles) and composited apart.
class ExactOrder : public CellOrder {
 public:
  //   kit   must outlive the order
  ExactOrder(const gpu::Context& context, VisibilityKit& kit, SortVariant variant);

  CellSequence record(const OrderInputs& inputs) override;
  std::uint64_t sizeBytes() const override { return storage_ ? storage_->sizeBytes() : 0; }

 private:
  void recordStart(const OrderInputs& inputs);
  void recordPeel(const OrderInputs& inputs);
  shared::PeelStatus peelAll(const OrderInputs& inputs);
  CycleReport resolve(const OrderInputs& inputs, std::uint32_t levelCount);

  const gpu::Context& context_;
  VisibilityKit& kit_;
  PeelPass peel_;
  SortPass sort_;
  std::unique_ptr<PeelStorage> storage_;  // made when first needed
};

}  // namespace tetralux::render
