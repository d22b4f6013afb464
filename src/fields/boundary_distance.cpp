#include "fields/boundary_distance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace tetralux {
namespace {

// In parts of sigma. What the field's slope says beyond is rounding.
constexpr double kFarthest = 6.0;

// Slopes below this part of the largest one are none: exp(-kFarthest^2 / 2), an error function's at the farthest place.
constexpr double kNoSlope = 1.5e-8;

double largestOf(std::span<const double> numbers) {
  double largest = 0.0;
  for (const double number : numbers) largest = std::max(largest, std::abs(number));
  return largest;
}

// At every vertex, along its gradient; 0 where the slope is none.
std::vector<double> secondDerivatives(const GradientFit& fit, std::span<const glm::dvec3> gradients,
                                      std::span<const double> slopes, double leastSlope) {
  const std::vector<glm::dvec3> slopeGradients = fit.gradients(slopes);
  std::vector<double> second(slopes.size(), 0.0);
  for (size_t i = 0; i < second.size(); i++) {
    if (slopes[i] > leastSlope) second[i] = glm::dot(slopeGradients[i], gradients[i] / slopes[i]);
  }
  return second;
}

double estimatedSigma(double largestSlope, double largestSecond, double diagonal) {
  const double sigma = largestSlope / (std::sqrt(std::numbers::e) * largestSecond);
  return sigma < diagonal ? sigma : diagonal;  // also where there is no second derivative, or no slope at all
}

}  // namespace

std::vector<double> gradientMagnitudes(std::span<const glm::dvec3> gradients) {
  std::vector<double> magnitudes;
  magnitudes.reserve(gradients.size());
  for (const glm::dvec3& g : gradients)
    magnitudes.push_back(std::min(std::hypot(g.x, g.y, g.z), std::numeric_limits<double>::max()));
  return magnitudes;
}

BoundaryDistances boundaryDistances(const GradientFit& fit, std::span<const glm::dvec3> gradients,
                                    std::optional<double> sigma, double diagonal) {
  const std::vector<double> slopes = gradientMagnitudes(gradients);
  const double largestSlope = largestOf(slopes);
  const double leastSlope = kNoSlope * largestSlope;
  const std::vector<double> second = secondDerivatives(fit, gradients, slopes, leastSlope);
  BoundaryDistances result;
  result.sigma = sigma ? *sigma : estimatedSigma(largestSlope, largestOf(second), diagonal);
  result.distances.reserve(slopes.size());
  for (size_t i = 0; i < slopes.size(); i++) {
    const double inSigmas =
        slopes[i] > leastSlope ? std::clamp(-result.sigma * second[i] / slopes[i], -kFarthest, kFarthest) : kFarthest;
    result.distances.push_back(result.sigma * inSigmas);
  }
  return result;
}

}  // namespace tetralux
