// How many marked pixels a box of pixels holds.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/pixel_tiles.h"

namespace tetralux::reference {

// A summed-area table (Crow 1984): a box is counted in constant time. 4 bytes per pixel.
class PixelCounts {
 public:
  //   isMarked   of a pixel's index, row by row from the top; called once for each
  template <typename Function>
  PixelCounts(ImageSize size, const Function& isMarked)
      : stride_(size.width + 1), sums_((size_t{size.width} + 1) * (size_t{size.height} + 1), 0) {
    for (std::uint32_t y = 0; y < size.height; y++) {
      std::uint32_t row = 0;
      for (std::uint32_t x = 0; x < size.width; x++) {
        row += isMarked(size_t{y} * size.width + x) ? 1 : 0;
        sums_[(size_t{y} + 1) * stride_ + x + 1] = sums_[size_t{y} * stride_ + x + 1] + row;
      }
    }
  }

  // The box must lie inside the image or be empty.
  std::uint32_t count(const PixelBox& box) const {
    if (box.empty()) return 0;
    const auto at = [&](std::int32_t x, std::int32_t y) {
      return sums_[static_cast<size_t>(y) * stride_ + static_cast<size_t>(x)];
    };
    return at(box.highX + 1, box.highY + 1) - at(box.lowX, box.highY + 1) - at(box.highX + 1, box.lowY) +
           at(box.lowX, box.lowY);
  }

 private:
  size_t stride_;
  std::vector<std::uint32_t> sums_;
};

}  // namespace tetralux::reference
