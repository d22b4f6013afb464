// Pass "combine": a chunk of cells, blended in 16-bit floats, over what lies behind it.
#pragma once

#include <map>

#include "gpu/commands.h"

namespace tetralux::render {

class CombinePass {
 public:
  explicit CombinePass(const gpu::Context& context);

  // Blends the chunk over the picture. The chunk must be ready for sampling.
  void record(gpu::CommandBuffer& commands, const gpu::AttachmentImage& chunk, const gpu::AttachmentImage& picture,
              bool clear);

 private:
  const gpu::GraphicsPipeline& pipeline(VkFormat format);

  const gpu::Context& context_;
  gpu::Shader vertex_;
  gpu::Shader fragment_;
  std::map<VkFormat, gpu::GraphicsPipeline> pipelines_;
};

}  // namespace tetralux::render
