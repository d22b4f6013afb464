// From an error to the cheapest way of drawing a frame within it.
#pragma once

#include <string>
#include <vector>

#include "render/integration/integration.h"
#include "render/tolerance/cell_classes.h"

namespace tetralux::render {

// How a tolerance is spent: what integration, and what leaving out light behind nearly opaque cells may cost. The rest
// is for rounding: of coordinates, sums and the target.
inline constexpr double kIntegrationShare = 5.0 / 8.0;
inline constexpr double kOmissionShare = 1.0 / 8.0;
inline constexpr double kRoundingShare = 1.0 / 8.0;  // of Target::Auto

// One choice, in words and by its figure.
struct ToleranceDecision {
  std::string what;    // "integration"
  std::string choice;  // "exact, coarse parts"
  std::string reason;
  double figure = 0.0;  // that the choice rests on: a bound of the largest error per pixel and channel, or a count
};

struct TolerancePlan {
  double tolerance = 0.0;  // largest error per pixel and channel
  Integration integration = Integration::Exact;
  PartAccuracy accuracy = PartAccuracy::Full;
  float leastTransmittance = kLeastTransmittance;
  std::vector<ToleranceDecision> decisions;
};

// Chooses by bounds that hold for whole rays. With opacities that err by e_o and colours by e_w dL, both relative to a
// part's opacity, a ray errs by no more than e_o L + e_w dL (L the largest luminance, or 1 for alpha): replacing one
// part after the other changes it by T_i o_i times that, and sum T_i o_i <= 1. What is left out behind a
// transmittance T is at most T L.
//   largestLuminance   of all channels, over the field's range
TolerancePlan planTolerance(double tolerance, double largestLuminance, const CellClasses& classes);

// A plan that leaves everything exact.
//   reason   why there is no bound for less
TolerancePlan planFully(double tolerance, const std::string& reason);

// Largest channel of luminance of a transfer function between two scalars.
double largestLuminance(const TransferFunction& transfer, double low, double high);

}  // namespace tetralux::render
