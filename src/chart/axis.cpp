#include "chart/axis.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "chart/svg_text.h"

namespace tetralux::chart {
namespace {

constexpr double kSlack = 1e-9;  // of rounding, in decades

// 1, 2 or 5 times a power of ten: the last one up to the value, or the first one from it on.
double roundDown(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value) + kSlack));
  const double share = value / power * (1.0 + kSlack);
  return power * (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0);
}

double roundUp(double value) {
  const double down = roundDown(value);
  if (down >= value * (1.0 - kSlack)) return down;
  const double power = std::pow(10.0, std::floor(std::log10(down) + kSlack));
  const double share = down / power;
  return power * (share < 1.5 ? 2.0 : share < 3.0 ? 5.0 : 10.0);
}

}  // namespace

Axis Axis::logarithmic(const std::vector<double>& values) {
  std::vector<double> positive;
  for (const double value : values) {
    if (value > 0.0 && std::isfinite(value)) positive.push_back(value);
  }
  if (positive.empty()) positive = {1.0, 10.0};
  const auto [least, most] = std::minmax_element(positive.begin(), positive.end());
  Axis axis;
  axis.isLogarithmic_ = true;
  constexpr double kRoom = 1.06;
  axis.low_ = roundDown(*least / kRoom);
  axis.high_ = roundUp(*most * kRoom);
  const bool isLong = std::log10(axis.high_ / axis.low_) > 3.0 + kSlack;
  const int first = static_cast<int>(std::floor(std::log10(axis.low_) + kSlack));
  const int last = static_cast<int>(std::ceil(std::log10(axis.high_) - kSlack));
  const int step = last - first > 12 ? 2 : 1;  // decades between numbers
  for (int decade = first; decade <= last; decade++) {
    for (const int factor : {1, 2, 5}) {
      const double value = factor * std::pow(10.0, decade);
      if (value < axis.low_ * (1.0 - kSlack) || value > axis.high_ * (1.0 + kSlack)) continue;
      const bool hasText = isLong ? factor == 1 && decade % step == 0 : true;
      axis.ticks_.push_back({value, hasText ? numberText(value) : ""});
    }
  }
  return axis;
}

Axis Axis::linearFromZero(const std::vector<double>& values) {
  Axis axis;
  double largest = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, value);
  }
  if (largest == 0.0) largest = 1.0;
  const double step = roundUp(largest / 6.0);
  const double count = std::ceil(largest / step - kSlack);
  axis.high_ = count * step;
  for (int i = 0; i <= static_cast<int>(count); i++) axis.ticks_.push_back({i * step, numberText(i * step)});
  return axis;
}

Axis Axis::logarithmicAt(std::vector<Tick> ticks) {
  CHECK_LT(size_t{0}, ticks.size());
  Axis axis;
  axis.isLogarithmic_ = true;
  std::sort(ticks.begin(), ticks.end(), [](const Tick& a, const Tick& b) { return a.value < b.value; });
  axis.ticks_ = std::move(ticks);
  const double room = std::pow(axis.ticks_.back().value / axis.ticks_.front().value, 0.04) * 1.05;
  axis.low_ = axis.ticks_.front().value / room;
  axis.high_ = axis.ticks_.back().value * room;
  return axis;
}

double Axis::share(double value) const {
  if (isLogarithmic_) return std::log(value / low_) / std::log(high_ / low_);
  return (value - low_) / (high_ - low_);
}

}  // namespace tetralux::chart
