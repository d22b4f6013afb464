// What a tolerance makes of a scene, decided from counts and bounds alone.
#include <gtest/gtest.h>

#include "render/projection.h"
#include "render/tolerance/tolerance_plan.h"

namespace tetralux::render {
namespace {

CellClasses someClasses() {
  CellClasses classes;
  classes.average = 10;
  classes.linear = 20;
  classes.pieces = 30;
  classes.worstMean = 0.4;
  classes.worstChange = 1.0;
  return classes;
}

TEST(TolerancePlan, SpendsNoMoreThanItHas) {
  for (const double luminance : {0.1, 1.0, 7.0}) {
    for (double tolerance = 1.0; tolerance > 1e-6; tolerance /= 3.0) {
      const TolerancePlan plan = planTolerance(tolerance, luminance, someClasses());
      const double brightest = std::max(luminance, 1.0);
      const PartError error = partError(plan.accuracy);
      if (plan.accuracy != PartAccuracy::Full) {
        EXPECT_LE(error.opacity * brightest + error.moment, kIntegrationShare * tolerance);
      }
      if (plan.leastTransmittance > kLeastTransmittance) {
        EXPECT_LE(static_cast<double>(plan.leastTransmittance) * brightest, 1.0001 * kOmissionShare * tolerance);
      }
    }
  }
}

TEST(TolerancePlan, GrowsCheaperAsTheToleranceGrows) {
  PartAccuracy accuracy = PartAccuracy::Full;
  float transmittance = 0.0f;
  for (double tolerance = 1e-6; tolerance < 1.0; tolerance *= 2.0) {
    const TolerancePlan plan = planTolerance(tolerance, 1.0, someClasses());
    EXPECT_GE(plan.accuracy, accuracy);
    EXPECT_GE(plan.leastTransmittance, transmittance);
    accuracy = plan.accuracy;
    transmittance = plan.leastTransmittance;
  }
  EXPECT_EQ(accuracy, PartAccuracy::Coarse);
}

TEST(TolerancePlan, TakesTheMeanOnlyWhereItIsGoodEnoughForEveryCell) {
  CellClasses classes = someClasses();
  EXPECT_EQ(planTolerance(0.1, 1.0, classes).integration, Integration::Exact);
  classes.pieces = 0;
  EXPECT_EQ(planTolerance(0.1, 1.0, classes).integration, Integration::Exact);
  classes.linear = 0;
  EXPECT_EQ(planTolerance(0.1, 1.0, classes).integration, Integration::Average);
}

TEST(TolerancePlan, LeavesEmissionPerLengthExact) {
  const TolerancePlan plan = planFully(0.1, "emission per length");
  EXPECT_EQ(plan.accuracy, PartAccuracy::Full);
  EXPECT_EQ(plan.leastTransmittance, kLeastTransmittance);
}

TEST(TolerancePlan, KnowsTheBrightestPartOfTheRangeAlone) {
  const TransferFunction transfer({{0, {0.2, 0, 0}, 1}, {1, {0.4, 0.1, 0}, 1}, {2, {5, 0, 0}, 1}}, "test");
  EXPECT_NEAR(largestLuminance(transfer, 0.0, 1.0), 0.4, 1e-12);
  EXPECT_NEAR(largestLuminance(transfer, 0.0, 1.5), 2.7, 1e-12);
  EXPECT_NEAR(largestLuminance(transfer, 0.5, 0.5), 0.3, 1e-12);
  EXPECT_NEAR(largestLuminance(transfer, 3.0, 9.0), 5.0, 1e-12);
}

TEST(ProjectionChoice, DependsOnWhatIsAskedForAlone) {
  EXPECT_EQ(chooseProjection(/*isWalkable=*/true).projection, CellProjection::March);
  EXPECT_EQ(chooseProjection(/*isWalkable=*/false).projection, CellProjection::Silhouette);
}

}  // namespace
}  // namespace tetralux::render
