#include "fields/boundary_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/generate.h"

namespace tetralux {
namespace {

const glm::dvec3 kNormal = glm::normalize(glm::dvec3(2, -1, 3));
const glm::dvec3 kMiddle(0.5, 0.45, 0.55);

double distanceOf(const glm::dvec3& p) { return glm::dot(p - kMiddle, kNormal); }

// A step from 2 to 7, blurred: the error function's boundary has its middle at distance 0.
std::vector<double> blurredStep(const TetMesh& mesh, double sigma) {
  std::vector<double> values;
  for (size_t i = 0; i < mesh.pointCount(); i++)
    values.push_back(4.5 + 2.5 * std::erf(distanceOf(mesh.point(i)) / (sigma * std::sqrt(2.0))));
  return values;
}

BoundaryDistances distancesOf(const TetMesh& mesh, const std::vector<double>& values,
                              std::optional<double> sigma = std::nullopt) {
  const GradientFit fit(mesh);
  return boundaryDistances(fit, fit.gradients(values), sigma, mesh.bounds().diagonal());
}

const TetMesh& box() {
  static const TetMesh mesh = jitteredGrid(30, 30, 30, {0, 0, 0}, {1, 1, 1}, 0.1, 1, waveField);
  return mesh;
}

TEST(BoundaryDistances, AreTheDistancesFromABlurredStep) {
  constexpr double kSigma = 0.15;
  const TetMesh& mesh = box();
  const auto found = distancesOf(mesh, blurredStep(mesh, kSigma), kSigma);
  EXPECT_EQ(found.sigma, kSigma);
  double largest = 0.0;
  double sum = 0.0;
  size_t count = 0;
  for (size_t i = 0; i < mesh.pointCount(); i++) {
    const glm::dvec3 p = mesh.point(i);
    const double margin = std::min({p.x, p.y, p.z, 1.0 - p.x, 1.0 - p.y, 1.0 - p.z});
    if (margin < 0.1 || std::abs(distanceOf(p)) > kSigma) continue;
    const double error = std::abs(found.distances[i] - distanceOf(p));
    largest = std::max(largest, error);
    sum += error;
    count++;
  }
  ASSERT_GT(count, 1000u);
  EXPECT_LT(sum / static_cast<double>(count), 0.02 * kSigma);
  EXPECT_LT(largest, 0.1 * kSigma);
}

// The largest of many second derivatives is the one with the largest error: sigma comes out a little small.
TEST(BoundaryDistances, SigmaIsEstimatedFromTheLargestDerivatives) {
  for (const double sigma : {0.12, 0.15, 0.2}) {
    const auto found = distancesOf(box(), blurredStep(box(), sigma));
    EXPECT_NEAR(found.sigma, sigma, 0.15 * sigma);
  }
}

TEST(BoundaryDistances, ScaleWithTheUnitOfLengthAndNotWithTheFields) {
  const std::vector<double> values = blurredStep(box(), 0.15);
  const auto expected = distancesOf(box(), values);
  TetMesh scaled = box();
  for (glm::dvec3& p : std::get<std::vector<glm::dvec3>>(scaled.points)) p *= 1024.0;
  std::vector<double> scaledValues = values;
  for (double& value : scaledValues) value *= 0x1p-40;
  const auto found = distancesOf(scaled, scaledValues);
  EXPECT_EQ(found.sigma, 1024.0 * expected.sigma);
  for (size_t i = 0; i < values.size(); i++) ASSERT_EQ(found.distances[i], 1024.0 * expected.distances[i]);
}

TEST(BoundaryDistances, WithoutASlopeThereIsNoBoundaryNear) {
  const TetMesh& mesh = box();
  const auto constant = distancesOf(mesh, std::vector<double>(mesh.pointCount(), 3.0), 0.1);
  for (const double distance : constant.distances) ASSERT_EQ(distance, 6.0 * 0.1);
  const auto estimated = distancesOf(mesh, std::vector<double>(mesh.pointCount(), 3.0));
  EXPECT_EQ(estimated.sigma, mesh.bounds().diagonal());
}

TEST(BoundaryDistances, NeverExceedSixSigma) {
  const auto found = distancesOf(box(), blurredStep(box(), 0.02), 0.02);
  for (const double distance : found.distances) ASSERT_LE(std::abs(distance), 6.0 * 0.02);
}

TEST(BoundaryDistances, SigmaOfALinearFieldIsNoLargerThanTheMesh) {
  const TetMesh& mesh = box();
  std::vector<double> values;
  for (size_t i = 0; i < mesh.pointCount(); i++) values.push_back(distanceOf(mesh.point(i)));
  EXPECT_EQ(distancesOf(mesh, values).sigma, mesh.bounds().diagonal());
}

TEST(GradientMagnitudes, AreLengthsAndFinite) {
  const std::vector<glm::dvec3> gradients = {{3, 4, 12}, {0, 0, 0}, {1e308, 1e308, 1e308}, {3e-300, 0, 4e-300}};
  const auto magnitudes = gradientMagnitudes(gradients);
  EXPECT_EQ(magnitudes[0], 13.0);
  EXPECT_EQ(magnitudes[1], 0.0);
  EXPECT_TRUE(std::isfinite(magnitudes[2]));
  EXPECT_DOUBLE_EQ(magnitudes[3], 5e-300);
}

}  // namespace
}  // namespace tetralux
