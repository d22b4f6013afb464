// Light and opacity of a segment whose optics depend on more than the scalar (docs/appearance.md).
#pragma once

#include <vector>

#include "volume/appearance.h"
#include "volume/transfer_function.h"

namespace tetralux::reference {

// A number at the two ends of a segment, linear in between.
struct EndValues {
  double front = 0.0;
  double back = 0.0;
};

// What a segment's optics depend on. Of the numbers those count that the appearance asks for.
struct ClassifiedSegment {
  EndValues scalar;
  std::vector<EndValues> modulators;  // one per modulation
  EndValues gradientMagnitude;        // of a transfer function of two dimensions
  glm::dvec4 rgbaFront{0.0};          // luminance and extinction, >= 0, of an rgba field
  glm::dvec4 rgbaBack{0.0};
  Illumination lightFront;  // of a volume that is lit; else the default, which changes nothing
  Illumination lightBack;
  double length = 0.0;  // world units, >= 0
};

// Whether an appearance's volume needs this: integrateSegment() does where it does not.
bool isClassified(const Appearance& appearance);

struct ClassifiedOptics {
  SegmentOptics optics;
  std::uint32_t pieces = 0;  // parts on which everything is smooth
};

// Integrates the part of a segment from the share uFrom of its length to uTo. It is cut wherever a curve, the transfer
// function or a line of its grid has a kink; in between extinction and luminance are products of linear functions, and
// integrated as such (smooth_integral.h), to about 1e-13 whatever the optical depth. Light from an rgba field or a
// transfer function of two dimensions is emitted per extinction, from a transfer function as that says.
//   uFrom, uTo   0 <= uFrom <= uTo <= 1
ClassifiedOptics integrateClassified(const TransferFunction& transfer, const Appearance& appearance,
                                     const ClassifiedSegment& segment, double uFrom, double uTo);

}  // namespace tetralux::reference
