#include "render/order/cell_order.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.h"

namespace tetralux::render {

const std::vector<std::string>& orderNames() {
  static const std::vector<std::string> names = {"auto",  "none",  "bucket",  "bitonic",
                                                 "radix", "power", "kbuffer", "exact"};
  return names;
}

const char* orderName(Order order) { return orderNames()[static_cast<size_t>(order)].c_str(); }

Order parseOrder(const std::string& name) {
  const auto& names = orderNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    fail(ErrorCode::Usage, "--order: found '{}', expected one of {}", name, fmt::join(names, ", "));
  return static_cast<Order>(found - names.begin());
}

bool OrderReport::isExact() const {
  if (order == Order::KBuffer) return shortPixels == 0;  // counted in every frame
  return isChecked && misordered == 0 && misorderedRelations == 0;
}

}  // namespace tetralux::render
