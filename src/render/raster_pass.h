// Pass "raster": light through every cell of a batch, blended over what lies behind.
#pragma once

#include "render/cell_draw.h"

namespace tetralux::render {

class RasterPass {
 public:
  explicit RasterPass(const gpu::Context& context);

  // Draws a batch into the attachment.
  void recordBatch(gpu::CommandBuffer& commands, const FrameVariant& variant, const CellBatch& batch,
                   const gpu::AttachmentImage& target, bool clear);

 private:
  CellDraw cells_;
};

}  // namespace tetralux::render
