#include "render/raster_pass.h"

#include "render/shader_library.h"
#include "shared/spec_ids.h"

namespace tetralux::render {

RasterPass::RasterPass(const gpu::Context& context)
    : context_(context),
      vertex_(loadShader(context, "raster/fan.vert")),
      fragment_(loadShader(context, "raster/fan.frag")) {}

void RasterPass::recordBatch(gpu::CommandBuffer& commands, const FrameVariant& variant, const shared::RasterPush& push,
                             const TransferBuffer& transfer, const IntegrationTables& tables,
                             const BatchStorage& batches, const gpu::AttachmentImage& target, bool clear) {
  commands.beginRendering(target, clear);
  commands.drawIndexedIndirect(pipeline(variant, target.format()),
                               {batches.modesView, batches.endsView, transfer.pieces(), transfer.pieceBins(),
                                tables.numbers(), tables.table2d(), tables.table3d()},
                               push, {&batches.positions, &batches.ends}, batches.indices, batches.arguments,
                               offsetof(shared::BatchArguments, indexCount));
  commands.endRendering();
}

const gpu::GraphicsPipeline& RasterPass::pipeline(const FrameVariant& variant, VkFormat format) {
  const Key key{
      variant.perspective, variant.emissionPerLength, variant.silhouette, variant.integration, variant.output, format};
  const auto found = pipelines_.find(key);
  if (found != pipelines_.end()) return found->second;
  gpu::GraphicsState state;
  state.streams = {{VK_FORMAT_R32G32_SFLOAT, 8}, {VK_FORMAT_R32G32B32A32_SFLOAT, 16}};
  state.colorFormat = format;
  gpu::SpecConstants constants = variant.integration.specConstants();
  constants.push_back({SPEC_PERSPECTIVE, variant.perspective});
  constants.push_back({SPEC_EMISSION_PER_LENGTH, variant.emissionPerLength});
  constants.push_back({SPEC_SILHOUETTE, variant.silhouette});
  constants.push_back({SPEC_OUTPUT, variant.output});
  return pipelines_.emplace(key, gpu::GraphicsPipeline(context_, vertex_, fragment_, state, constants)).first->second;
}

}  // namespace tetralux::render
