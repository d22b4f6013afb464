#include "render/combine_pass.h"

#include "render/shader_library.h"

namespace tetralux::render {

CombinePass::CombinePass(const gpu::Context& context)
    : context_(context),
      vertex_(loadShader(context, "apart/blend.vert")),
      fragment_(loadShader(context, "combine/combine.frag")) {}

void CombinePass::record(gpu::CommandBuffer& commands, const gpu::AttachmentImage& chunk,
                         const gpu::AttachmentImage& picture, bool clear) {
  commands.beginRendering(picture, clear);
  commands.draw(pipeline(picture.format()), {chunk}, gpu::NoPush{}, 3);
  commands.endRendering();
}

const gpu::GraphicsPipeline& CombinePass::pipeline(VkFormat format) {
  const auto found = pipelines_.find(format);
  if (found != pipelines_.end()) return found->second;
  gpu::GraphicsState state;
  state.colorFormat = format;
  return pipelines_.emplace(format, gpu::GraphicsPipeline(context_, vertex_, fragment_, state)).first->second;
}

}  // namespace tetralux::render
