// Pipelines whose layouts come from the shaders themselves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/shader.h"

namespace tetralux::gpu {

// Values of specialisation constants: id (shaders-glsl/shared/spec_ids.h) and 32-bit value.
struct SpecConstant {
  std::uint32_t id = 0;
  std::uint32_t value = 0;
};
using SpecConstants = std::vector<SpecConstant>;

// What both kinds have in common: push descriptors of set 0 and one range of push constants.
class PipelineLayout {
 public:
  PipelineLayout() = default;
  PipelineLayout(const Context& context, std::span<const Shader* const> shaders);

  VkPipelineLayout get() const { return layout_.get(); }
  const std::vector<VkDescriptorType>& bindings() const { return bindings_; }  // indexed by binding number
  std::uint32_t pushConstantBytes() const { return pushConstantBytes_; }
  VkShaderStageFlags stages() const { return stages_; }

 private:
  std::vector<VkDescriptorType> bindings_;
  std::uint32_t pushConstantBytes_ = 0;
  VkShaderStageFlags stages_ = 0;
  DeviceHandle<VkDescriptorSetLayout> setLayout_;
  DeviceHandle<VkPipelineLayout> layout_;
};

class ComputePipeline {
 public:
  ComputePipeline() = default;
  ComputePipeline(const Context& context, const Shader& shader, const SpecConstants& constants = {});

  VkPipeline get() const { return pipeline_.get(); }
  const PipelineLayout& layout() const { return layout_; }
  std::uint32_t workgroupSize() const { return workgroupSize_; }

 private:
  PipelineLayout layout_;
  std::uint32_t workgroupSize_ = 1;
  DeviceHandle<VkPipeline> pipeline_;
};

// One vertex attribute in a buffer of its own, tightly packed; its location is its index.
struct VertexStream {
  VkFormat format = VK_FORMAT_UNDEFINED;
  std::uint32_t strideBytes = 0;
};

struct GraphicsState {
  std::vector<VertexStream> streams;
  VkFormat colorFormat = VK_FORMAT_UNDEFINED;  // undefined: no attachment, the fragment shader writes to buffers
  bool blendOver = true;  // premultiplied source over destination; otherwise the source replaces it
};

// Indexed triangles, no culling, no depth buffer, viewport and scissor set while recording.
class GraphicsPipeline {
 public:
  GraphicsPipeline() = default;
  GraphicsPipeline(const Context& context, const Shader& vertex, const Shader& fragment, const GraphicsState& state,
                   const SpecConstants& constants = {});

  VkPipeline get() const { return pipeline_.get(); }
  const PipelineLayout& layout() const { return layout_; }

 private:
  PipelineLayout layout_;
  DeviceHandle<VkPipeline> pipeline_;
};

}  // namespace tetralux::gpu
