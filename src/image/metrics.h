// How far two images are apart.
#pragma once

#include <cstdint>

#include "image/image.h"

namespace tetralux {

// Differences over all pixels and the four channels R, G, B, A, as numbers of the linear premultiplied image.
struct ImageDifference {
  double rmse = 0.0;    // root of the mean squared difference
  double max = 0.0;     // largest absolute difference
  double p99 = 0.0;     // 99th percentile of the absolute differences (nearest rank)
  double mean = 0.0;    // mean absolute difference
  double shareOverHalfLevel = 0.0;  // share of pixels with a channel off by more than 0.5/255, 0..1
  double psnr = 0.0;    // 20 log10(1 / rmse), dB; infinity for equal images
  double flip = 0.0;    // mean FLIP error (Andersson et al. 2020) of the colours over black, 0..1
  std::uint64_t nonFinite = 0;  // values that are NaN or infinite in one image only, or different there; the figures
                                // above count each as a difference of 1
  std::uint32_t worstX = 0;  // a pixel with the largest difference
  std::uint32_t worstY = 0;
};

// Throws Error(Input) when the sizes differ.
ImageDifference compareImages(const Image& reference, const Image& test);

// Mean FLIP error of two images (LDR-FLIP, Andersson et al. 2020) at 67 pixels per degree; colours are linear RGB,
// clamped to [0, 1]. Sizes must agree.
double flipError(const Image& reference, const Image& test);

}  // namespace tetralux
