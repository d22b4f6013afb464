#include "volume/transfer_function.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace tetralux {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

OpticalSample sampleOf(const ControlPoint& p) { return {p.rgb, p.tau}; }

void checkPoint(const ControlPoint& p, size_t index, std::string_view place) {
  const auto check = [&](const char* name, double value, bool mayBeNegative) {
    if (!std::isfinite(value) || (value < 0.0 && !mayBeNegative))
      fail(ErrorCode::Input, "{}: point {}: {} is {}, expected a finite number{}", place, index, name, value,
           mayBeNegative ? "" : " >= 0");
  };
  check("s", p.s, true);
  check("rgb[0]", p.rgb[0], false);
  check("rgb[1]", p.rgb[1], false);
  check("rgb[2]", p.rgb[2], false);
  check("tau", p.tau, false);
}

}  // namespace

OpticalSample TransferPiece::at(double s) const {
  if (!(high - low < kInfinity)) return atLow;  // an end piece is constant
  const double t = std::clamp((s - low) / (high - low), 0.0, 1.0);
  return {atLow.luminance * (1.0 - t) + atHigh.luminance * t, atLow.extinction * (1.0 - t) + atHigh.extinction * t};
}

TransferFunction::TransferFunction(std::vector<ControlPoint> points, std::string_view place, Emission emission)
    : points_(std::move(points)), emission_(emission) {
  if (points_.empty()) fail(ErrorCode::Input, "{}: has no point, expected at least one", place);
  for (size_t i = 0; i < points_.size(); i++) {
    checkPoint(points_[i], i, place);
    if (i > 0 && points_[i].s < points_[i - 1].s)
      fail(ErrorCode::Input, "{}: point {}: s is {}, expected at least that of the point before, {}", place, i,
           points_[i].s, points_[i - 1].s);
  }
  const ControlPoint& first = points_.front();
  const ControlPoint& last = points_.back();
  pieces_.push_back({-kInfinity, first.s, sampleOf(first), sampleOf(first)});
  for (size_t i = 1; i < points_.size(); i++) {
    if (points_[i].s > points_[i - 1].s)
      pieces_.push_back({points_[i - 1].s, points_[i].s, sampleOf(points_[i - 1]), sampleOf(points_[i])});
  }
  pieces_.push_back({last.s, kInfinity, sampleOf(last), sampleOf(last)});
}

size_t TransferFunction::pieceIndex(double s) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), s,
                                      [](double value, const TransferPiece& piece) { return value < piece.low; });
  return static_cast<size_t>(after - pieces_.begin()) - 1;
}

double TransferFunction::largestExtinction() const {
  double largest = 0.0;
  for (const ControlPoint& p : points_) largest = std::max(largest, p.tau);
  return largest;
}

bool TransferFunction::isTransparent(double low, double high) const {
  const auto shows = [&](const OpticalSample& sample) {
    return sample.extinction > 0.0 || (emission_ == Emission::PerLength && sample.luminance != glm::dvec3(0.0));
  };
  const size_t last = pieceIndex(high);
  for (size_t i = pieceIndex(low); i <= last; i++) {
    const TransferPiece& piece = pieces_[i];
    if (shows(piece.at(std::max(low, piece.low))) || shows(piece.at(std::min(high, piece.high)))) return false;
  }
  return true;
}

TransferFunction TransferFunction::scaled(double factor) const {
  std::vector<ControlPoint> points = points_;
  for (ControlPoint& p : points) p.tau *= factor;
  return TransferFunction(std::move(points), "scaled transfer function", emission_);
}

}  // namespace tetralux
