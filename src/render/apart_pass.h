// Pass "apart": cells whose order differs from pixel to pixel, composited by a list of segments per pixel.
#pragma once

#include "render/batch.h"
#include "render/frame_view.h"
#include "render/integration/integration_tables.h"
#include "render/pipeline_variants.h"
#include "render/pixel_lists.h"
#include "render/transfer_buffer.h"

namespace tetralux::render {

class ApartPass {
 public:
  explicit ApartPass(const gpu::Context& context);

  // Draws a projected batch into the lists of a band.
  //   firstSlot   of the batch
  //   kBuffer     0: lists will be sorted by depth; otherwise they go through a k-buffer in drawing order
  void recordStore(gpu::CommandBuffer& commands, const FrameVariant& variant, const shared::RasterPush& push,
                   const TransferBuffer& transfer, const IntegrationTables& tables, const BatchStorage& batches,
                   std::uint32_t firstSlot, const PixelLists& lists, const shared::PixelBand& band,
                   std::uint32_t kBuffer);

  // Composites the lists of a band and blends them over the attachment.
  //   shortPixels   one uint: adds the pixels where the k-buffer was too small
  void recordResolve(gpu::CommandBuffer& commands, const PixelLists& lists, const shared::PixelBand& band,
                     std::uint32_t kBuffer, const gpu::Buffer& shortPixels);
  void recordBlend(gpu::CommandBuffer& commands, const FrameVariant& variant, const PixelLists& lists,
                   const shared::PixelBand& band, const gpu::AttachmentImage& target, bool clear);

 private:
  const gpu::GraphicsPipeline& storePipeline(const FrameVariant& variant, std::uint32_t kBuffer);
  const gpu::GraphicsPipeline& blendPipeline(std::uint32_t output, VkFormat format);

  const gpu::Context& context_;
  gpu::Shader fanVertex_;
  gpu::Shader storeFragment_;
  gpu::Shader blendVertex_;
  gpu::Shader blendFragment_;
  ComputeVariants resolve_;
  struct StoreKey {
    bool perspective;
    bool emissionPerLength;
    bool silhouette;
    IntegrationVariant integration;
    std::uint32_t kBuffer;
    auto operator<=>(const StoreKey&) const = default;
  };
  std::map<StoreKey, gpu::GraphicsPipeline> store_;
  std::map<std::pair<std::uint32_t, VkFormat>, gpu::GraphicsPipeline> blend_;
};

}  // namespace tetralux::render
