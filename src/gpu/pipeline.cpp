#include "gpu/pipeline.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace tetralux::gpu {
namespace {

// The driver's form of specialisation constants; the pointers are into itself.
class Specialization {
 public:
  explicit Specialization(const SpecConstants& constants) {
    for (const SpecConstant& c : constants) {
      entries_.push_back(
          {c.id, static_cast<std::uint32_t>(data_.size() * sizeof(std::uint32_t)), sizeof(std::uint32_t)});
      data_.push_back(c.value);
    }
    info_ = {static_cast<std::uint32_t>(entries_.size()), entries_.data(), data_.size() * sizeof(std::uint32_t),
             data_.data()};
  }
  Specialization(const Specialization&) = delete;
  Specialization& operator=(const Specialization&) = delete;

  const VkSpecializationInfo* get() const { return &info_; }

 private:
  std::vector<VkSpecializationMapEntry> entries_;
  std::vector<std::uint32_t> data_;
  VkSpecializationInfo info_{};
};

VkPipelineShaderStageCreateInfo stageInfo(const Shader& shader, const Specialization& specialization) {
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = shader.interface().stage;
  info.module = shader.get();
  info.pName = "main";
  info.pSpecializationInfo = specialization.get();
  return info;
}

}  // namespace

PipelineLayout::PipelineLayout(const Context& context, std::span<const Shader* const> shaders) {
  for (const Shader* shader : shaders) {
    const ShaderInterface& interface = shader->interface();
    stages_ |= interface.stage;
    pushConstantBytes_ = std::max(pushConstantBytes_, interface.pushConstantBytes);
    for (const ShaderInterface::Binding& binding : interface.bindings) {
      if (binding.number >= bindings_.size()) bindings_.resize(binding.number + 1, VK_DESCRIPTOR_TYPE_MAX_ENUM);
      CHECK(bindings_[binding.number] == VK_DESCRIPTOR_TYPE_MAX_ENUM || bindings_[binding.number] == binding.type);
      bindings_[binding.number] = binding.type;
    }
  }
  std::vector<VkDescriptorSetLayoutBinding> layoutBindings;
  for (std::uint32_t i = 0; i < bindings_.size(); i++) {
    CHECK(bindings_[i] != VK_DESCRIPTOR_TYPE_MAX_ENUM);
    layoutBindings.push_back({i, bindings_[i], 1, stages_, nullptr});
  }
  VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  setInfo.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
  setInfo.bindingCount = static_cast<std::uint32_t>(layoutBindings.size());
  setInfo.pBindings = layoutBindings.data();
  VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
  VK_CHECK(vkCreateDescriptorSetLayout(context.device(), &setInfo, nullptr, &setLayout));
  setLayout_ = {context.device(), setLayout, vkDestroyDescriptorSetLayout};

  const VkPushConstantRange range{stages_, 0, pushConstantBytes_};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = 1;
  info.pSetLayouts = &setLayout;
  info.pushConstantRangeCount = pushConstantBytes_ > 0 ? 1 : 0;
  info.pPushConstantRanges = &range;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VK_CHECK(vkCreatePipelineLayout(context.device(), &info, nullptr, &layout));
  layout_ = {context.device(), layout, vkDestroyPipelineLayout};
}

ComputePipeline::ComputePipeline(const Context& context, const Shader& shader, const SpecConstants& constants)
    : workgroupSize_(shader.interface().localSize[0]) {
  CHECK(shader.interface().stage == VK_SHADER_STAGE_COMPUTE_BIT);
  const std::array<const Shader*, 1> shaders = {&shader};
  layout_ = PipelineLayout(context, shaders);
  const Specialization specialization(constants);
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage = stageInfo(shader, specialization);
  info.layout = layout_.get();
  VkPipeline pipeline = VK_NULL_HANDLE;
  VK_CHECK(vkCreateComputePipelines(context.device(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline));
  pipeline_ = {context.device(), pipeline, vkDestroyPipeline};
  context.setName(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(pipeline), shader.name());
}

GraphicsPipeline::GraphicsPipeline(const Context& context, const Shader& vertex, const Shader& fragment,
                                   const GraphicsState& state, const SpecConstants& constants) {
  const std::array<const Shader*, 2> shaders = {&vertex, &fragment};
  layout_ = PipelineLayout(context, shaders);
  const Specialization specialization(constants);
  const std::array<VkPipelineShaderStageCreateInfo, 2> stages = {stageInfo(vertex, specialization),
                                                                 stageInfo(fragment, specialization)};

  std::vector<VkVertexInputBindingDescription> bindings;
  std::vector<VkVertexInputAttributeDescription> attributes;
  for (std::uint32_t i = 0; i < state.streams.size(); i++) {
    bindings.push_back({i, state.streams[i].strideBytes, VK_VERTEX_INPUT_RATE_VERTEX});
    attributes.push_back({i, i, state.streams[i].format, 0});
  }
  VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  input.vertexBindingDescriptionCount = static_cast<std::uint32_t>(bindings.size());
  input.pVertexBindingDescriptions = bindings.data();
  input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size());
  input.pVertexAttributeDescriptions = attributes.data();
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = 1;
  viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.cullMode = VK_CULL_MODE_NONE;
  raster.lineWidth = 1.0f;
  VkPipelineMultisampleStateCreateInfo multisample{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineColorBlendAttachmentState blend{};
  blend.blendEnable = state.blendOver ? VK_TRUE : VK_FALSE;
  blend.srcColorBlendFactor = VK_BLEND_FACTOR_ONE;
  blend.dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  blend.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  blend.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  blend.colorWriteMask =
      VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  VkPipelineColorBlendStateCreateInfo blendState{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  const std::uint32_t attachments = state.colorFormat == VK_FORMAT_UNDEFINED ? 0 : 1;
  blendState.attachmentCount = attachments;
  blendState.pAttachments = &blend;
  const std::array<VkDynamicState, 2> dynamicStates = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamicStates.size());
  dynamic.pDynamicStates = dynamicStates.data();
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = attachments;
  rendering.pColorAttachmentFormats = &state.colorFormat;

  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering};
  info.stageCount = static_cast<std::uint32_t>(stages.size());
  info.pStages = stages.data();
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &multisample;
  info.pColorBlendState = &blendState;
  info.pDynamicState = &dynamic;
  info.layout = layout_.get();
  VkPipeline pipeline = VK_NULL_HANDLE;
  VK_CHECK(vkCreateGraphicsPipelines(context.device(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline));
  pipeline_ = {context.device(), pipeline, vkDestroyPipeline};
  context.setName(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(pipeline), fragment.name());
}

}  // namespace tetralux::gpu
