#include "reference/classified_integral.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "reference/smooth_integral.h"

namespace tetralux::reference {
namespace {

using Polynomials = Bernstein<glm::dvec4>;  // luminance or a factor of it, and extinction or a factor of it

double at(const EndValues& values, double u) { return std::lerp(values.front, values.back, u); }

glm::dvec4 toVector(const OpticalSample& sample) { return {sample.luminance, sample.extinction}; }

// A part of a segment without a kink. Where a number is looked up, its value in the middle says where: at the ends it
// may be on a step.
struct Part {
  double u0 = 0.0;
  double u1 = 1.0;

  double middle() const { return 0.5 * (u0 + u1); }
};

// Places along a segment, the ends of the range among them, ascending.
class Cuts {
 public:
  Cuts(double uFrom, double uTo) : places_{uFrom, uTo} {}

  // Cuts where a number has the value `kink`.
  void add(const EndValues& values, double kink) {
    if (!(std::min(values.front, values.back) < kink && kink < std::max(values.front, values.back))) return;
    const double u = (kink - values.front) / (values.back - values.front);
    if (u > places_[0] && u < places_[1]) places_.push_back(u);
  }

  std::vector<Part> parts() const {
    std::vector<double> sorted = places_;
    std::sort(sorted.begin(), sorted.end());
    std::vector<Part> parts;
    for (size_t i = 1; i < sorted.size(); i++) {
      if (sorted[i] > sorted[i - 1]) parts.push_back({sorted[i - 1], sorted[i]});
    }
    return parts;
  }

 private:
  std::vector<double> places_;
};

Polynomials transferOptics(const TransferFunction& transfer, const EndValues& scalar, const Part& part) {
  const TransferPiece& piece = transfer.pieces()[transfer.pieceIndex(at(scalar, part.middle()))];
  return Polynomials({toVector(piece.at(at(scalar, part.u0))), toVector(piece.at(at(scalar, part.u1)))});
}

// The interval of an axis that a part lies in, and where in it the part's two ends are; outside the axis the interval
// is one of its ends.
struct AxisPart {
  size_t low = 0;
  size_t high = 0;
  EndValues share;  // 0 to 1

  AxisPart(const std::vector<double>& axis, const EndValues& values, const Part& part) {
    const double middle = at(values, part.middle());
    high = std::min(static_cast<size_t>(std::upper_bound(axis.begin(), axis.end(), middle) - axis.begin()),
                    axis.size() - 1);
    low = middle < axis.front() ? 0 : middle >= axis.back() ? axis.size() - 1 : high - 1;
    if (low == high) return;
    const auto shareAt = [&](double u) {
      return std::clamp((at(values, u) - axis[low]) / (axis[high] - axis[low]), 0.0, 1.0);
    };
    share = {shareAt(part.u0), shareAt(part.u1)};
  }
};

// Bilinear in two numbers that are linear in x: quadratic, its middle coefficient the mean of the two mixed corners
// (the polynomial's blossom; Ramshaw 1989, "Blossoms are polar forms").
Polynomials gridOptics(const TransferFunction2d& transfer, const ClassifiedSegment& segment, const Part& part) {
  const AxisPart s(transfer.scalars(), segment.scalar, part);
  const AxisPart g(transfer.gradients(), segment.gradientMagnitude, part);
  const auto sample = [&](size_t i, size_t j) {
    return toVector(transfer.samples()[i + j * transfer.scalars().size()]);
  };
  const auto mixed = [&](double p, double q) {
    return (1.0 - q) * ((1.0 - p) * sample(s.low, g.low) + p * sample(s.high, g.low)) +
           q * ((1.0 - p) * sample(s.low, g.high) + p * sample(s.high, g.high));
  };
  return Polynomials({mixed(s.share.front, g.share.front),
                      0.5 * (mixed(s.share.front, g.share.back) + mixed(s.share.back, g.share.front)),
                      mixed(s.share.back, g.share.back)});
}

Polynomials factorOptics(const FactorCurve& curve, const EndValues& values, const Part& part, bool isPerLength) {
  const std::vector<FactorPoint>& points = curve.points();
  const auto after = std::upper_bound(points.begin(), points.end(), at(values, part.middle()),
                                      [](double value, const FactorPoint& point) { return value < point.value; });
  const FactorPoint& high = after == points.end() ? points.back() : *after;
  const FactorPoint& low = after == points.begin() ? points.front() : *(after - 1);
  const auto valueAt = [&](double u) {
    const double share =
        low.value < high.value ? std::clamp((at(values, u) - low.value) / (high.value - low.value), 0.0, 1.0) : 0.0;
    const glm::dvec3 rgb = (1.0 - share) * low.rgb + share * high.rgb;
    return glm::dvec4(rgb, (1.0 - share) * low.factor + share * high.factor);
  };
  const Polynomials factor({valueAt(part.u0), valueAt(part.u1)});
  if (!isPerLength) return factor;
  // Light emitted per length is multiplied by both.
  const auto extinctionFactor = [&](double u) { return glm::dvec4(glm::dvec3(valueAt(u).w), 1.0); };
  return factor * Polynomials({extinctionFactor(part.u0), extinctionFactor(part.u1)});
}

Cuts cutsOf(const TransferFunction& transfer, const Appearance& appearance, const ClassifiedSegment& segment,
            double uFrom, double uTo) {
  Cuts cuts(uFrom, uTo);
  if (appearance.rgbaField) {
    // Linear: no kinks.
  } else if (appearance.transfer2d) {
    for (const double s : appearance.transfer2d->scalars()) cuts.add(segment.scalar, s);
    for (const double g : appearance.transfer2d->gradients()) cuts.add(segment.gradientMagnitude, g);
  } else {
    for (const ControlPoint& point : transfer.points()) cuts.add(segment.scalar, point.s);
  }
  for (size_t i = 0; i < appearance.modulations.size(); i++) {
    for (const FactorPoint& point : appearance.modulations[i].curve.points())
      cuts.add(segment.modulators[i], point.value);
  }
  return cuts;
}

Illumination illuminationAt(const ClassifiedSegment& segment, double u) {
  const Illumination& a = segment.lightFront;
  const Illumination& b = segment.lightBack;
  return {(1.0 - u) * a.factor + u * b.factor, (1.0 - u) * a.highlight + u * b.highlight};
}

SegmentOptics integratePart(const TransferFunction& transfer, const Appearance& appearance,
                            const ClassifiedSegment& segment, const Part& part, bool isPerLength) {
  const auto rgbaAt = [&](double u) { return (1.0 - u) * segment.rgbaFront + u * segment.rgbaBack; };
  Polynomials optics = appearance.rgbaField    ? Polynomials({rgbaAt(part.u0), rgbaAt(part.u1)})
                       : appearance.transfer2d ? gridOptics(*appearance.transfer2d, segment, part)
                                               : transferOptics(transfer, segment.scalar, part);
  for (size_t i = 0; i < appearance.modulations.size(); i++)
    optics = optics * factorOptics(appearance.modulations[i].curve, segment.modulators[i], part, isPerLength);

  const double length = (part.u1 - part.u0) * segment.length;
  std::vector<double> extinction;
  for (const glm::dvec4& c : optics.coefficients()) extinction.push_back(length * c.w);
  return SmoothIntegral(Bernstein<double>(std::move(extinction)).integral())([&](double x) {
    const glm::dvec4 here = optics.at(x);
    const Illumination light = illuminationAt(segment, std::lerp(part.u0, part.u1, x));
    const glm::dvec3 lit = glm::dvec3(here) * light.factor;
    return isPerLength ? length * lit : length * here.w * (lit + light.highlight);
  });
}

}  // namespace

bool isClassified(const Appearance& appearance) {
  return appearance.volumeShading != Shading::None || !appearance.modulations.empty() || appearance.rgbaField ||
         appearance.transfer2d;
}

ClassifiedOptics integrateClassified(const TransferFunction& transfer, const Appearance& appearance,
                                     const ClassifiedSegment& segment, double uFrom, double uTo) {
  CHECK_EQ(segment.modulators.size(), appearance.modulations.size());
  const bool isPerLength =
      transfer.emission() == Emission::PerLength && !appearance.rgbaField && !appearance.transfer2d;
  ClassifiedOptics result;
  double transmittance = 1.0;
  for (const Part& part : cutsOf(transfer, appearance, segment, uFrom, uTo).parts()) {
    const SegmentOptics optics = integratePart(transfer, appearance, segment, part, isPerLength);
    result.optics.light += transmittance * optics.light;
    result.optics.alpha += (1.0 - result.optics.alpha) * optics.alpha;
    transmittance *= 1.0 - optics.alpha;
    result.pieces++;
  }
  return result;
}

}  // namespace tetralux::reference
