// Passes "order" and "check": cells that hide each other without a shared face.
#pragma once

#include <memory>

#include "render/order/cell_order.h"
#include "render/peel_pass.h"
#include "render/pixel_lists.h"
#include "render/shader_library.h"

namespace tetralux::render {

// Draws the mesh's boundary into lists of where rays enter and leave it, and relates the cells on both sides of each
// gap. Only needed for meshes that are not convex.
class Relations {
 public:
  explicit Relations(const gpu::Context& context);

  // Lets cells wait for those behind them across gaps: adds to peel.waiting and fills the relation lists of the peel
  // storage. After PeelPass::recordWait; a barrier towards compute is recorded at its end. What there was no room for
  // is missing.
  void recordAdd(const OrderInputs& inputs, const GpuTopology& topology, const PeelStorage& peel);

  // Lets cells that overlap wait for each other, in the same way.
  void recordOverlaps(const OrderInputs& inputs, const GpuTopology& topology, const PeelStorage& peel);

  // Counts the pairs that sort keys put the wrong way round into an OrderCount.
  //   range          bits of the key that the sort looks at
  //   tiesAreApart   equal keys are right
  void recordCheck(const OrderInputs& inputs, const GpuTopology& topology, SortRange range, bool tiesAreApart,
                   const gpu::Buffer& count);

  // After the recorder has run: whether there was too little room for the entries and exits. If so there is more now,
  // and the work must be recorded again.
  bool grow() { return lists_ && lists_->grow(); }

  std::uint64_t sizeBytes() const { return unused_.sizeBytes() + (lists_ ? lists_->sizeBytes() : 0); }

 private:
  void recordBoundary(gpu::CommandBuffer& commands, const OrderInputs& inputs, const GpuTopology& topology,
                      const shared::PixelBand& band);
  void prepareLists(ImageSize size);

  const gpu::Context& context_;
  gpu::Shader boundaryVertex_;
  gpu::Shader boundaryFragment_;
  std::map<std::pair<bool, bool>, gpu::GraphicsPipeline> boundary_;  // by perspective, wide addressing
  ComputeVariants relate_;
  ComputeVariants overlap_;
  std::unique_ptr<PixelLists> lists_;  // made when first needed
  gpu::Buffer unused_;                 // stands for what a variant of relate.comp does not touch
  gpu::TexelView unusedView_;
};

}  // namespace tetralux::render
