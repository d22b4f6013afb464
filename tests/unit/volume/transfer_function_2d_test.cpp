#include "volume/transfer_function_2d.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace tetralux {
namespace {

using test::errorOf;

const std::vector<OpticalSample> kCorners = {
    {glm::dvec3(0.0), 0.0}, {glm::dvec3(1.0), 1.0}, {glm::dvec3(2.0), 2.0}, {glm::dvec3(4.0), 7.0}};

TEST(TransferFunction2d, IsBilinearInsideAndConstantOutside) {
  const TransferFunction2d transfer({0.0, 1.0}, {10.0, 20.0}, kCorners, "f");
  EXPECT_EQ(transfer.at(0.0, 10.0).extinction, 0.0);
  EXPECT_EQ(transfer.at(1.0, 20.0).extinction, 7.0);
  EXPECT_EQ(transfer.at(0.5, 15.0).extinction, 0.25 * (0.0 + 1.0 + 2.0 + 7.0));
  EXPECT_EQ(transfer.at(0.5, 0.0).luminance.y, 0.5);
  EXPECT_EQ(transfer.at(-5.0, 99.0).extinction, 2.0);
  EXPECT_EQ(transfer.largestExtinction(), 7.0);
}

TEST(TransferFunction2d, SaysWhatIsWrong) {
  const auto message = [](std::vector<double> scalars, std::vector<double> gradients) {
    return errorOf(ErrorCode::Input, [&] { TransferFunction2d(scalars, gradients, kCorners, "place"); });
  };
  EXPECT_EQ(message({}, {1.0}), "place: scalars: found none, expected at least one number");
  EXPECT_EQ(message({0.0, 1.0}, {1.0, 1.0}), "place: gradients[1]: found 1, expected finite numbers that ascend");
  EXPECT_EQ(message({0.0, 1.0, 2.0}, {1.0, 2.0}), "place: found 4 samples, expected 3 x 2");
}

}  // namespace
}  // namespace tetralux
