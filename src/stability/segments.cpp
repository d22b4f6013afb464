#include "stability/segments.h"

#include "gpu/commands.h"
#include "render/shader_library.h"
#include "render/transfer_buffer.h"
#include "shared/spec_ids.h"

namespace tetralux::stability {

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
  const render::IntegrationVariant variant{integration, render::Interpolation::Perspective, tables.needsFetch(),
                                           accuracy};
  gpu::SpecConstants constants = variant.specConstants();
  constants.push_back({SPEC_EMISSION_PER_LENGTH, transfer.emission() == Emission::PerLength});
  const gpu::ComputePipeline pipeline(context, render::loadShader(context, "test/integrate.comp"), constants);
  gpu::CommandBuffer commands(context);
  commands.dispatch(
      pipeline, {pieces.pieces(), pieces.pieceBins(), tables.numbers(), tables.table2d(), tables.table3d(), in, out},
      static_cast<std::uint32_t>(segments.size()), segments.size());
  commands.submitAndWait();
  return gpu::downloadVector<glm::vec4>(context, out, segments.size());
}

}  // namespace tetralux::stability
