#include "volume/transfer_function_2d.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace tetralux {
namespace {

void checkAxis(const std::vector<double>& axis, const char* name, std::string_view place) {
  if (axis.empty()) fail(ErrorCode::Input, "{}: {}: found none, expected at least one number", place, name);
  for (size_t i = 0; i < axis.size(); i++) {
    if (!std::isfinite(axis[i]) || (i > 0 && !(axis[i] > axis[i - 1])))
      fail(ErrorCode::Input, "{}: {}[{}]: found {}, expected finite numbers that ascend", place, name, i, axis[i]);
  }
}

struct Place {
  size_t low;
  size_t high;
  double share;  // of the high one
};

Place placeOn(const std::vector<double>& axis, double value) {
  if (!(value > axis.front())) return {0, 0, 0.0};
  if (!(value < axis.back())) return {axis.size() - 1, axis.size() - 1, 0.0};
  const auto high = static_cast<size_t>(std::upper_bound(axis.begin(), axis.end(), value) - axis.begin());
  return {high - 1, high, (value - axis[high - 1]) / (axis[high] - axis[high - 1])};
}

OpticalSample mixed(const OpticalSample& a, const OpticalSample& b, double share) {
  return {a.luminance * (1.0 - share) + b.luminance * share, a.extinction * (1.0 - share) + b.extinction * share};
}

}  // namespace

TransferFunction2d::TransferFunction2d(std::vector<double> scalars, std::vector<double> gradients,
                                       std::vector<OpticalSample> samples, std::string_view place)
    : scalars_(std::move(scalars)), gradients_(std::move(gradients)), samples_(std::move(samples)) {
  checkAxis(scalars_, "scalars", place);
  checkAxis(gradients_, "gradients", place);
  if (samples_.size() != scalars_.size() * gradients_.size())
    fail(ErrorCode::Input, "{}: found {} samples, expected {} x {}", place, samples_.size(), scalars_.size(),
         gradients_.size());
  for (size_t i = 0; i < samples_.size(); i++) {
    const OpticalSample& s = samples_[i];
    for (const double number : {s.luminance.x, s.luminance.y, s.luminance.z, s.extinction}) {
      if (!(std::isfinite(number) && number >= 0.0))
        fail(ErrorCode::Input, "{}: sample of gradient {}, scalar {}: found {}, expected a finite number >= 0", place,
             i / scalars_.size(), i % scalars_.size(), number);
    }
  }
}

OpticalSample TransferFunction2d::at(double scalar, double gradient) const {
  const Place s = placeOn(scalars_, scalar);
  const Place g = placeOn(gradients_, gradient);
  const auto row = [&](size_t j) {
    return mixed(samples_[j * scalars_.size() + s.low], samples_[j * scalars_.size() + s.high], s.share);
  };
  return mixed(row(g.low), row(g.high), g.share);
}

double TransferFunction2d::largestExtinction() const {
  double largest = 0.0;
  for (const OpticalSample& sample : samples_) largest = std::max(largest, sample.extinction);
  return largest;
}

}  // namespace tetralux
