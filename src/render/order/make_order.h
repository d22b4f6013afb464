// From the name of an order to the order.
#pragma once

#include "render/order/cell_order.h"
#include "render/order/order_check.h"

namespace tetralux::render {

// Bits of the cull pass's keys: distances are compared in single precision, more bits than its significand has would
// sort rounding errors.
inline constexpr std::uint32_t kCentroidKeyBits = 24;

// What orders are made from.
struct OrderMesh {
  const TetMesh& mesh;
  const MeshSpace& space;      // of the mesh on the device
  const Adjacency* adjacency;  // may be null where needsVisibility is false
};

// Whether an order cannot be drawn without knowing which cells are neighbours.
bool needsVisibility(Order order);

//   mesh      not kept
//   kBuffer   segments, for Order::KBuffer
//   kit       may be null where needsVisibility is false and no frame asks for a check; must outlive the order
std::unique_ptr<CellOrder> makeOrder(const gpu::Context& context, const OrderMesh& mesh, Order order,
                                     std::uint32_t kBuffer, SortVariant variant, VisibilityKit* kit);

}  // namespace tetralux::render
