#include "render/apart_pass.h"

#include "render/shader_library.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
ApartPass::ApartPass(const gpu::Context& context)
    : context_(context),
      store_(context, "apart/store.frag", "apart/gator.frag", "apart/appearance.frag"),
      blendVertex_(loadShader(context, "apart/blend.vert")),
      blendFragment_(loadShader(context, "apart/blend.frag")),
      resolve_(context, "apart/resolve.comp") {}

void ApartPass::recordStore(gpu::CommandBuffer& commands, const FrameVariant& variant, const CellBatch& batch,
                            const PixelLists& lists) {
  const shared::PixelBand& band = batch.push.band;
  commands.beginRendering(lists.size().width, lists.size().height, {band.firstRow, band.rowCount});
  store_.record(commands, variant, batch, VK_FORMAT_UNDEFINED, batch.sequence.kBuffer,
                {lists.heads(), lists.links(), lists.ranks(), lists.colors(), lists.counts()});
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
