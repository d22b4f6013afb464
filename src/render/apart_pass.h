// Pass "apart": cells whose order differs from pixel to pixel, composited by a list of segments per pixel.
#pragma once

#include "render/cell_draw.h"
#include "render/pixel_lists.h"

namespace tetralux::render {

class ApartPass {
 public:
  explicit ApartPass(const gpu::Context& context);

  // Draws a batch into the lists of the band that it names. They will be sorted by depth, or go through the k-buffer of
  // its sequence in drawing order.
  void recordStore(gpu::CommandBuffer& commands, const FrameVariant& variant, const CellBatch& batch,
                   const PixelLists& lists);

  // Composites the lists of a band and blends them over the attachment.
  //   shortPixels   one uint: adds the pixels where the k-buffer was too small
  void recordResolve(gpu::CommandBuffer& commands, const PixelLists& lists, const shared::PixelBand& band,
                     std::uint32_t kBuffer, const gpu::Buffer& shortPixels);
  void recordBlend(gpu::CommandBuffer& commands, const FrameVariant& variant, const PixelLists& lists,
                   const shared::PixelBand& band, const gpu::AttachmentImage& target, bool clear);

 private:
  const gpu::GraphicsPipeline& blendPipeline(std::uint32_t output, VkFormat format);

  const gpu::Context& context_;
  CellDraw store_;
  gpu::Shader blendVertex_;
  gpu::Shader blendFragment_;
  ComputeVariants resolve_;
  std::map<std::pair<std::uint32_t, VkFormat>, gpu::GraphicsPipeline> blend_;
};

}  // namespace tetralux::render
