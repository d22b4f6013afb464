#include "render/order/make_order.h"

#include "base/check.h"
#include "render/order/auto_order.h"
#include "render/order/bitonic_order.h"
#include "render/order/exact_order.h"
#include "render/order/kbuffer_order.h"
#include "render/order/key_order.h"
#include "render/order/power_order.h"
#include "shared/limits.h"

namespace tetralux::render {
namespace {

SortRange keyRange(Order order) {
  // No bit but one above all that are used: the sort then only drops what is not drawn.
  if (order == Order::None) return {kCentroidKeyBits, 1};
  if (order == Order::Bucket) return {kCentroidKeyBits - shared::SORT_DIGIT_BITS, shared::SORT_DIGIT_BITS};
  return {0, kCentroidKeyBits};
}

}  // namespace

bool needsVisibility(Order order) { return order == Order::Auto || order == Order::Power || order == Order::Exact; }

std::unique_ptr<CellOrder> makeOrder(const gpu::Context& context, const OrderMesh& mesh, Order order,
                                     std::uint32_t kBuffer, SortVariant variant, VisibilityKit* kit) {
  CHECK((kit != nullptr && mesh.adjacency != nullptr) || !needsVisibility(order));
  OrderCheck* check = kit ? &kit->check : nullptr;
  switch (order) {
    case Order::Auto: {
      std::vector<std::unique_ptr<KeyOrder>> keyed;
      keyed.push_back(std::make_unique<KeyOrder>(context, Order::Radix, keyRange(Order::Radix), variant, check));
      // Power saves a little more than a third of what peeling costs, on Delaunay meshes only, and takes longer at load than it
      // saves in several frames.
      return std::make_unique<AutoOrder>(context, std::move(keyed), *kit, variant);
    }
    case Order::Exact:
      return std::make_unique<ExactOrder>(context, *kit, variant);
    case Order::Bitonic:
      return std::make_unique<BitonicOrder>(context, check);
    case Order::Power:
      return std::make_unique<PowerOrder>(context, mesh, kit->topology, variant, check);
    case Order::KBuffer:
      return std::make_unique<KBufferOrder>(context, kBuffer, keyRange(Order::Radix), variant, check);
    default:
      return std::make_unique<KeyOrder>(context, order, keyRange(order), variant, check);
  }
}

}  // namespace tetralux::render
