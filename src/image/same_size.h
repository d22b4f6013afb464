// What every comparison of two images asks of them.
#pragma once

#include "base/check.h"
#include "base/error.h"
#include "image/image.h"

namespace tetralux {

// Throws Error(Input), with both sizes, when they differ.
inline void requireSameSize(const Image& reference, const Image& test) {
  for (const Image* image : {&reference, &test}) {
    CHECK_LT(0u, image->pixels.size());
    CHECK_EQ(image->pixels.size(), static_cast<size_t>(image->width) * image->height);
  }
  if (reference.width != test.width || reference.height != test.height)
    fail(ErrorCode::Input, "images of different size: {} x {} pixels, expected {} x {} like the reference", test.width,
         test.height, reference.width, reference.height);
}

}  // namespace tetralux
