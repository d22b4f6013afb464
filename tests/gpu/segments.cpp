#include "segments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "gpu_fixture.h"
#include "reference/segment_integral.h"
#include "render/transfer_buffer.h"
#include "shared/spec_ids.h"
#include "test_modules.h"

namespace tetralux::test {

render::MeshSpace unitSpace() {
  render::MeshSpace space;
  space.scalarCenter = 0.5;
  return space;
}

Segment roundedSegment(const Segment& segment) {
  const render::MeshSpace space = unitSpace();
  const auto rounded = [&](double s) {
    return static_cast<double>(space.scalar(s)) * space.scalarRange + space.scalarCenter;
  };
  return {rounded(segment.front), rounded(segment.back), static_cast<double>(static_cast<float>(segment.length))};
}

std::vector<glm::vec4> integrateOnDevice(const gpu::Context& context, const TransferFunction& transfer,
                                         const std::vector<Segment>& segments, render::Integration integration,
                                         const render::TableOptions& options, const render::CellLengths& lengths,
                                         render::PartAccuracy accuracy) {
  const render::MeshSpace space = unitSpace();
  const render::TransferBuffer pieces(context, transfer, space);
  render::IntegrationTables tables(context);
  tables.build(integration, options, {pieces, lengths});
  std::vector<glm::vec4> input;
  for (const Segment& s : segments)
    input.emplace_back(space.scalar(s.front), space.scalar(s.back), static_cast<float>(s.length), 0.0f);
  const gpu::Buffer in = gpu::makeBuffer(context, input, "segments");
  const gpu::Buffer out = gpu::makeBuffer(context, std::vector<glm::vec4>(segments.size()), "results");
  const EmbeddedFile* file = findEmbedded(test_modules::files(), "test/integrate.comp.spv");
  CHECK(file != nullptr);
  const gpu::Shader shader(context, "test/integrate.comp",
                           {reinterpret_cast<const std::uint32_t*>(file->data), file->sizeBytes / 4});
  const render::IntegrationVariant variant{integration, render::Interpolation::Perspective, tables.needsFetch(),
                                           accuracy};
  gpu::SpecConstants constants = variant.specConstants();
  constants.push_back({SPEC_EMISSION_PER_LENGTH, transfer.emission() == Emission::PerLength});
  const gpu::ComputePipeline pipeline(context, shader, constants);
  runCommands(context, [&](gpu::CommandBuffer& commands) {
    commands.dispatch(
        pipeline, {pieces.pieces(), pieces.pieceBins(), tables.numbers(), tables.table2d(), tables.table3d(), in, out},
        static_cast<std::uint32_t>(segments.size()), segments.size());
  });
  return gpu::downloadVector<glm::vec4>(context, out, segments.size());
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
