// Pass "raster": light through every cell of a batch, blended over what lies behind.
#pragma once

#include "gpu/commands.h"
#include "render/batch.h"
#include "render/frame_view.h"
#include "render/integration/integration_tables.h"
#include "render/pipeline_variants.h"
#include "render/transfer_buffer.h"

namespace tetralux::render {

class RasterPass {
 public:
  explicit RasterPass(const gpu::Context& context);

  // Draws a batch, projected before, into the attachment.
  void recordBatch(gpu::CommandBuffer& commands, const FrameVariant& variant, const shared::RasterPush& push,
                   const TransferBuffer& transfer, const IntegrationTables& tables, const BatchStorage& batches,
                   const gpu::AttachmentImage& target, bool clear);

 private:
  const gpu::GraphicsPipeline& pipeline(const FrameVariant& variant, VkFormat format);

  const gpu::Context& context_;
  gpu::Shader vertex_;
  gpu::Shader fragment_;
  struct Key {
    bool perspective;
    bool emissionPerLength;
    bool silhouette;
    IntegrationVariant integration;
    std::uint32_t output;
    VkFormat format;
    auto operator<=>(const Key&) const = default;
  };
  std::map<Key, gpu::GraphicsPipeline> pipelines_;
};

}  // namespace tetralux::render
