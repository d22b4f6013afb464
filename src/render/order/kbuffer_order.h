// Order "kbuffer": an approximate order, mended at every pixel.
#pragma once

#include "render/order/cell_order.h"
#include "render/order/order_check.h"

namespace tetralux::render {

// Sorts cells by centroid distance and sends every pixel's segments through a buffer of the k nearest (Callahan, Ikits,
// Comba and Silva 2005, HAVS; there k is 2 or 6). Pixels where k was too small are counted.
class KBufferOrder : public CellOrder {
 public:
  //   k       segments, 1 to KBUFFER_LARGEST
  //   check   needed where a frame asks for it, may be null otherwise; must outlive the order. It counts what the
  //           sort got wrong, before the buffer mends it.
  KBufferOrder(const gpu::Context& context, std::uint32_t k, SortRange range, SortVariant variant, OrderCheck* check);

  CellSequence record(const OrderInputs& inputs) override;
  std::uint64_t sizeBytes() const override { return 0; }

 private:
  std::uint32_t k_;
  SortRange range_;
  SortPass sort_;
  OrderCheck* check_;
};

}  // namespace tetralux::render
