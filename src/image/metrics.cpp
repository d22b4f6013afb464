#include "image/metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/check.h"
#include "base/error.h"
#include "image/same_size.h"

namespace tetralux {
namespace {

// The `count` largest of many values, in memory for twice as many.
class LargestValues {
 public:
  explicit LargestValues(size_t count) : count_(count) { values_.reserve(2 * count); }

  void add(double value) {
    if (value <= floor_) return;
    values_.push_back(value);
    if (values_.size() == 2 * count_) shrink();
  }

  // The smallest of them. At least `count` values were added.
  double smallest() {
    CHECK_LE(count_, values_.size());
    shrink();
    return floor_;
  }

 private:
  void shrink() {
    const auto last = values_.begin() + static_cast<std::ptrdiff_t>(count_ - 1);
    std::nth_element(values_.begin(), last, values_.end(), std::greater<>());
    floor_ = *last;
    values_.resize(count_);
  }

  size_t count_;
  std::vector<double> values_;
  double floor_ = -1.0;  // `count` values are at least this large; below all of them before there are so many
};

// Nearest rank: of n values in ascending order the one at rank ceil(0.99 n) = n - floor(n / 100), counted from 1. Seen
// from the top that is this one.
size_t p99FromTop(size_t count) { return count / 100 + 1; }

struct ValueDifference {
  double size;
  bool nonFinite;
};

ValueDifference differenceOf(float a, float b) {
  if (std::isfinite(a) && std::isfinite(b)) return {std::abs(static_cast<double>(a) - static_cast<double>(b)), false};
  const bool same = a == b || (std::isnan(a) && std::isnan(b));
  return {same ? 0.0 : 1.0, !same};
}

}  // namespace

ImageDifference compareImages(const Image& reference, const Image& test) {
  requireSameSize(reference, test);
  constexpr double kHalfLevel = 0.5 / 255.0;
  ImageDifference result;
  const size_t values = reference.pixels.size() * 4;
  LargestValues largest(p99FromTop(values));
  double sum = 0.0;
  double squares = 0.0;
  std::uint64_t over = 0;
  for (std::uint32_t y = 0; y < reference.height; y++) {
    double rowSum = 0.0;  // sums of sums lose less than one long sum
    double rowSquares = 0.0;
    for (std::uint32_t x = 0; x < reference.width; x++) {
      const glm::vec4& a = reference.at(x, y);
      const glm::vec4& b = test.at(x, y);
      double worst = 0.0;
      for (int c = 0; c < 4; c++) {
        const ValueDifference difference = differenceOf(a[c], b[c]);
        result.nonFinite += difference.nonFinite;
        rowSum += difference.size;
        rowSquares += difference.size * difference.size;
        worst = std::max(worst, difference.size);
        largest.add(difference.size);
      }
      over += worst > kHalfLevel;
      if (worst > result.max) {
        result.max = worst;
        result.worstX = x;
        result.worstY = y;
      }
    }
    sum += rowSum;
    squares += rowSquares;
  }
  result.mean = sum / static_cast<double>(values);
  result.rmse = std::sqrt(squares / static_cast<double>(values));
  result.p99 = largest.smallest();
  result.shareOverHalfLevel = static_cast<double>(over) / static_cast<double>(reference.pixels.size());
  result.psnr = -20.0 * std::log10(result.rmse);
  result.flip = flipError(reference, test);
  return result;
}

}  // namespace tetralux
