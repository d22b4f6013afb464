#include "render/truth_table.h"

#include <vector>

namespace tetralux::render {
namespace {

constexpr std::uint32_t kCrossing = 4;

std::uint32_t entry(const std::array<std::uint32_t, 4>& ring, std::uint32_t centre, std::uint32_t triangles,
                    std::uint32_t projectionClass) {
  std::uint32_t bits = 0;
  for (std::uint32_t i = 0; i < 4; i++) bits |= ring[i] << (2 * i);
  return bits | centre << 8 | triangles << 11 | projectionClass << 14;
}

std::uint32_t classify(const std::array<int, 4>& sign) {
  std::vector<std::uint32_t> positive;
  std::vector<std::uint32_t> negative;
  std::vector<std::uint32_t> zero;
  for (std::uint32_t i = 0; i < 4; i++) (sign[i] > 0 ? positive : sign[i] < 0 ? negative : zero).push_back(i);
  if (positive.empty() || negative.empty()) return 0;
  if (positive.size() == 2 && negative.size() == 2)
    return entry({positive[0], negative[0], positive[1], negative[1]}, kCrossing, 4, 2);

  // The vertex whose face stands alone against the others is where the ray's two ends are compared: it is one of them.
  const std::uint32_t centre = positive.size() == 1 ? positive[0] : negative[0];
  std::vector<std::uint32_t> ring;
  for (std::uint32_t i = 0; i < 4; i++) {
    if (i != centre) ring.push_back(i);
  }
  const auto zeros = static_cast<std::uint32_t>(zero.size());
  return entry({ring[0], ring[1], ring[2], ring[0]}, centre, 3 - zeros, zeros == 0 ? 1 : 2 + zeros);
}

}  // namespace

std::array<std::uint32_t, shared::TRUTH_TABLE_SIZE> makeTruthTable() {
  std::array<std::uint32_t, shared::TRUTH_TABLE_SIZE> table{};
  for (std::uint32_t index = 0; index < table.size(); index++) {
    std::array<int, 4> sign{};
    std::uint32_t rest = index;
    for (int i = 3; i >= 0; i--, rest /= 3) sign[static_cast<size_t>(i)] = static_cast<int>(rest % 3) - 1;
    table[index] = classify(sign);
  }
  return table;
}

}  // namespace tetralux::render
