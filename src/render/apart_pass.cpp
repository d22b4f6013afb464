#include "render/apart_pass.h"

#include "render/shader_library.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

struct StorePush {
  shared::RasterPush raster;
  shared::PixelBand band;
  std::uint32_t firstSlot;
};

}  // namespace

ApartPass::ApartPass(const gpu::Context& context)
    : context_(context),
      fanVertex_(loadShader(context, "raster/fan.vert")),
      storeFragment_(loadShader(context, "apart/store.frag")),
      blendVertex_(loadShader(context, "apart/blend.vert")),
      blendFragment_(loadShader(context, "apart/blend.frag")),
      resolve_(context, "apart/resolve.comp") {}

void ApartPass::recordStore(gpu::CommandBuffer& commands, const FrameVariant& variant, const shared::RasterPush& push,
                            const TransferBuffer& transfer, const IntegrationTables& tables,
                            const BatchStorage& batches, std::uint32_t firstSlot, const PixelLists& lists,
                            const shared::PixelBand& band, std::uint32_t kBuffer) {
  commands.beginRendering(lists.size().width, lists.size().height, {band.firstRow, band.rowCount});
  commands.drawIndexedIndirect(
      storePipeline(variant, kBuffer),
      {batches.modesView, batches.endsView, transfer.pieces(), transfer.pieceBins(), tables.numbers(), tables.table2d(),
       tables.table3d(), lists.heads(), lists.links(), lists.ranks(), lists.colors(), lists.counts()},
      StorePush{push, band, firstSlot}, {&batches.positions, &batches.ends}, batches.indices, batches.arguments,
      offsetof(shared::BatchArguments, indexCount));
  commands.endRendering();
}

void ApartPass::recordResolve(gpu::CommandBuffer& commands, const PixelLists& lists, const shared::PixelBand& band,
                              std::uint32_t kBuffer, const gpu::Buffer& shortPixels) {
  commands.dispatch(resolve_.get({{SPEC_KBUFFER, kBuffer}}),
                    {lists.heads(), lists.links(), lists.ranks(), lists.colors(), shortPixels}, band,
                    std::uint64_t{band.width} * band.rowCount);
}

void ApartPass::recordBlend(gpu::CommandBuffer& commands, const FrameVariant& variant, const PixelLists& lists,
                            const shared::PixelBand& band, const gpu::AttachmentImage& target, bool clear) {
  commands.beginRendering(target, clear, {band.firstRow, band.rowCount});
  commands.draw(blendPipeline(variant.output, target.format()), {lists.heads(), lists.colors()}, band, 3);
  commands.endRendering();
}

const gpu::GraphicsPipeline& ApartPass::storePipeline(const FrameVariant& variant, std::uint32_t kBuffer) {
  const StoreKey key{variant.perspective, variant.emissionPerLength, variant.silhouette, variant.integration, kBuffer};
  const auto found = store_.find(key);
  if (found != store_.end()) return found->second;
  gpu::GraphicsState state;
  state.streams = {{VK_FORMAT_R32G32_SFLOAT, 8}, {VK_FORMAT_R32G32B32A32_SFLOAT, 16}};
  gpu::SpecConstants constants = variant.integration.specConstants();
  constants.push_back({SPEC_PERSPECTIVE, variant.perspective});
  constants.push_back({SPEC_EMISSION_PER_LENGTH, variant.emissionPerLength});
  constants.push_back({SPEC_SILHOUETTE, variant.silhouette});
  constants.push_back({SPEC_KBUFFER, kBuffer});
  return store_.emplace(key, gpu::GraphicsPipeline(context_, fanVertex_, storeFragment_, state, constants))
      .first->second;
}

const gpu::GraphicsPipeline& ApartPass::blendPipeline(std::uint32_t output, VkFormat format) {
  const std::pair key{output, format};
  const auto found = blend_.find(key);
  if (found != blend_.end()) return found->second;
  gpu::GraphicsState state;
  state.colorFormat = format;
  const gpu::SpecConstants constants = {{SPEC_OUTPUT, output}};
  return blend_.emplace(key, gpu::GraphicsPipeline(context_, blendVertex_, blendFragment_, state, constants))
      .first->second;
}

}  // namespace tetralux::render
