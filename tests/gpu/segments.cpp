#include "segments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/segment_integral.h"

namespace tetralux::test {

double samplerFractionError(const gpu::Context& context) {
  return context.info().isCpu ? 0.0 : std::exp2(-1.0 - context.info().subtexelBits);
}

double largestError(const gpu::Context& context, const TransferFunction& transfer, const std::vector<Segment>& segments,
                    render::Integration integration, const render::TableOptions& options,
                    const render::CellLengths& lengths) {
  const auto found = integrateOnDevice(context, transfer, segments, integration, options, lengths);
  double worst = 0.0;
  for (size_t i = 0; i < segments.size(); i++) {
    const Segment s = roundedSegment(segments[i]);
    const SegmentOptics expected = reference::integrateSegment(transfer, s.front, s.back, s.length);
    for (int c = 0; c < 4; c++) {
      const double want = c < 3 ? expected.light[c] : expected.alpha;
      const double difference = std::abs(want - static_cast<double>(found[i][c]));
      EXPECT_TRUE(std::isfinite(difference))
          << segments[i].front << " " << segments[i].back << " " << segments[i].length;
      worst = std::max(worst, difference);
    }
  }
  return worst;
}

double largestRelativeError(const gpu::Context& context, const TransferFunction& transfer,
                            const std::vector<Segment>& segments, render::Integration integration,
                            const render::TableOptions& options, const render::CellLengths& lengths,
                            double opacityLimit) {
  const auto found = integrateOnDevice(context, transfer, segments, integration, options, lengths);
  double worst = 0.0;
  for (size_t i = 0; i < segments.size(); i++) {
    const Segment s = roundedSegment(segments[i]);
    const SegmentOptics expected = reference::integrateSegment(transfer, s.front, s.back, s.length);
    const double brightest = std::max({expected.light.x, expected.light.y, expected.light.z});
    for (int c = 0; c < 3; c++) {
      const double difference = std::abs(expected.light[c] - static_cast<double>(found[i][c]));
      EXPECT_TRUE(std::isfinite(difference));
      worst = std::max(worst, difference / std::max(brightest, 1e-30));
    }
    EXPECT_NEAR(expected.alpha, static_cast<double>(found[i].w), opacityLimit);
  }
  return worst;
}

}  // namespace tetralux::test
