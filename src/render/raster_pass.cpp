#include "render/raster_pass.h"

namespace tetralux::render {

RasterPass::RasterPass(const gpu::Context& context)
    : cells_(context, "raster/fan.frag", "raster/gator.frag", "raster/appearance.frag") {}

void RasterPass::recordBatch(gpu::CommandBuffer& commands, const FrameVariant& variant, const CellBatch& batch,
                             const gpu::AttachmentImage& target, bool clear) {
  commands.beginRendering(target, clear);
  cells_.record(commands, variant, batch, target.format());
  commands.endRendering();
}

}  // namespace tetralux::render
