// How far two images are apart.
#pragma once

#include <cstdint>

#include "image/image.h"

namespace tetralux {

// Differences over all pixels and the four channels R, G, B, A, as numbers of the linear premultiplied image. A value
// that is NaN or infinite in one image only, or another such value there, counts as a difference of 1; the same
// infinity or NaN in both is no difference.
struct ImageDifference {
  double rmse = 0.0;                // root of the mean squared difference
  double max = 0.0;                 // largest absolute difference
  double p99 = 0.0;                 // 99th percentile of the absolute differences (nearest rank)
  double mean = 0.0;                // mean absolute difference
  double shareOverHalfLevel = 0.0;  // share of pixels with a channel off by more than 0.5/255, 0..1
  double psnr = 0.0;                // 20 log10(1 / rmse), dB; infinity for equal images
  double flip = 0.0;                // flipError() of the colours over black, 0..1
  std::uint64_t nonFinite = 0;      // number of values counted as a difference of 1, see above
  std::uint32_t worstX = 0;         // the first pixel, row by row, with the largest difference
  std::uint32_t worstY = 0;
};

// Compares two images, neither of them empty. Throws Error(Input), with both sizes, when the sizes differ.
ImageDifference compareImages(const Image& reference, const Image& test);

// Mean FLIP error, 0..1, of two images as an observer sees them at 67 pixels per degree (LDR-FLIP, Andersson et al.
// 2020). Colours are linear RGB clamped to [0, 1], NaN taken as 0; alpha is ignored. Needs little memory beside the
// images, and gives the same bits whatever the number of threads. Throws Error(Input) when the sizes differ.
double flipError(const Image& reference, const Image& test);

}  // namespace tetralux
