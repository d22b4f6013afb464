#include "render/rounding_probe.h"

#include <cmath>
#include <glm/gtc/packing.hpp>

#include "render/shader_library.h"

namespace tetralux::render {

bool halfBlendingRoundsToNearest(const gpu::Context& context) {
  constexpr VkFormat kFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
  const gpu::AttachmentImage pixel(context, 1, 1, kFormat, "rounding probe");
  const gpu::Buffer readback(context, sizeof(std::uint64_t), gpu::MemoryKind::Readback, "rounding probe");
  const gpu::Shader vertex = loadShader(context, "apart/blend.vert");
  const gpu::Shader fragment = loadShader(context, "combine/probe.frag");
  gpu::GraphicsState state;
  state.colorFormat = kFormat;
  const gpu::GraphicsPipeline pipeline(context, vertex, fragment, state);
  // 1/2, whose neighbour is 2^-11 above, and three quarters of that step.
  const float steps[] = {0.5f, 0.75f * std::exp2(-11.0f)};
  gpu::CommandBuffer commands(context);
  commands.prepareAttachment(pixel);
  commands.beginRendering(pixel, /*clear=*/true);
  for (const float step : steps) commands.draw(pipeline, {}, glm::vec4(step, 0.0f, 0.0f, 0.0f), 3);
  commands.endRendering();
  commands.copyToBuffer(pixel, readback);
  commands.barrier(gpu::access::kTransferWrite, gpu::access::kHostRead);
  commands.submitAndWait();
  return glm::unpackHalf4x16(readback.as<std::uint64_t>()[0]).x > 0.5f;
}

bool halfFloatHolds(double roundings, bool roundsToNearest, double limit) {
  // A step of 16-bit floats below 1. To nearest: three standard deviations of a sum of evenly distributed errors.
  // Towards zero: a whole step each, because of a few layers some pixel loses nearly that.
  const double step = std::exp2(-11.0);
  const double error = roundsToNearest ? 3.0 * step * std::sqrt(roundings / 12.0) : step * roundings;
  return error < limit;
}

}  // namespace tetralux::render
