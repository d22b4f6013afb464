#include "reference/pixel_sample.h"

#include <algorithm>
#include <random>

#include "base/check.h"
#include "reference/pixel_tiles.h"

namespace tetralux::reference {
namespace {

// Numbers of the wanted pixels that are taken, ascending.
std::vector<std::uint64_t> stratifiedNumbers(std::uint64_t total, std::uint32_t count, std::uint32_t seed) {
  std::vector<std::uint64_t> numbers;
  if (total <= count) {
    for (std::uint64_t i = 0; i < total; i++) numbers.push_back(i);
    return numbers;
  }
  std::mt19937 random(seed);
  const double width = static_cast<double>(total) / count;
  for (std::uint32_t i = 0; i < count; i++) {
    // Real ends, rounded after the draw: whole ones would favour the pixels of the shorter strata.
    const double number = (i + static_cast<double>(random()) * 0x1p-32) * width;
    numbers.push_back(std::min(static_cast<std::uint64_t>(number), total - 1));
  }
  return numbers;
}

}  // namespace

std::vector<PixelPosition> stratifiedPixels(ImageSize size, const std::vector<std::uint8_t>& wanted,
                                            std::uint32_t count, std::uint32_t seed) {
  CHECK_EQ(wanted.size(), static_cast<size_t>(size.width) * size.height);
  const auto total = static_cast<std::uint64_t>(
      std::count_if(wanted.begin(), wanted.end(), [](std::uint8_t flag) { return flag != 0; }));
  const std::vector<std::uint64_t> numbers = stratifiedNumbers(total, count, seed);
  std::vector<PixelPosition> positions;
  std::uint64_t number = 0;
  auto next = numbers.begin();
  constexpr auto kSide = static_cast<std::uint32_t>(PixelTiles::kSide);
  for (std::uint32_t top = 0; top < size.height; top += kSide) {
    for (std::uint32_t left = 0; left < size.width; left += kSide) {
      for (std::uint32_t y = top; y < std::min(top + kSide, size.height); y++) {
        for (std::uint32_t x = left; x < std::min(left + kSide, size.width); x++) {
          if (wanted[static_cast<size_t>(y) * size.width + x] == 0) continue;
          for (; next != numbers.end() && *next == number; ++next) positions.push_back({x, y});
          number++;
        }
      }
    }
  }
  return positions;
}

}  // namespace tetralux::reference
