#include "volume/equalize.h"

#include <gtest/gtest.h>

namespace tetralux {
namespace {

const std::vector<ControlPoint> kColors = {{0, {}, 1}, {1, {}, 1}, {2, {}, 0}, {3, {}, 1}};

TEST(EqualizedOpacity, MeanOpticalDepthIsAsAsked) {
  std::vector<WeightedScalar> samples;
  for (int i = 0; i <= 300; i++) samples.push_back({i * 0.01, 1.0 + i});
  const TransferFunction transfer = equalizedOpacity(kColors, samples, 20.0, 2.5);
  double depth = 0.0;
  double weight = 0.0;
  for (const WeightedScalar& s : samples) {
    depth += s.weight * transfer.at(s.s).extinction;
    weight += s.weight;
  }
  EXPECT_NEAR(depth / weight * 20.0, 2.5, 1e-12);
}

TEST(EqualizedOpacity, RareValuesAreDenseAndHiddenOnesStayHidden) {
  const TransferFunction transfer = equalizedOpacity(kColors, {{0.0, 90.0}, {1.0, 9.0}, {3.0, 1e-9}}, 1.0, 3.0);
  EXPECT_EQ(transfer.at(2.0).extinction, 0.0);
  EXPECT_NEAR(transfer.at(1.0).extinction / transfer.at(0.0).extinction, 10.0, 1e-6);
  EXPECT_NEAR(transfer.at(3.0).extinction / transfer.at(0.0).extinction, 0.909090909 * 100, 1e-6);  // the limit
}

TEST(EqualizedOpacity, NoSamplesIsUniform) {
  const TransferFunction transfer = equalizedOpacity(kColors, {}, 1.0, 3.0);
  EXPECT_EQ(transfer.at(0.0).extinction, transfer.at(3.0).extinction);
  EXPECT_GT(transfer.at(0.0).extinction, 0.0);
}

}  // namespace
}  // namespace tetralux
