// Compiled shader modules, and what they say about themselves.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gpu/context.h"

namespace tetralux::gpu {

// What SPIR-V declares. Bindings of set 0 are expected to be numbered from 0 without gaps over all stages of a
// pipeline.
struct ShaderInterface {
  struct Binding {
    std::uint32_t number = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
  };
  VkShaderStageFlagBits stage = VK_SHADER_STAGE_ALL;
  std::vector<Binding> bindings;
  std::uint32_t pushConstantBytes = 0;
  std::array<std::uint32_t, 3> localSize = {1, 1, 1};  // compute
};

// Reads the interface from a module's words. Throws CheckFailure on words that are not SPIR-V as glslang writes it.
ShaderInterface reflect(std::span<const std::uint32_t> words);

// A module and its interface. `name` is its path under shaders-glsl and spirv: "project/project.comp".
class Shader {
 public:
  Shader() = default;
  Shader(const Context& context, const std::string& name, std::span<const std::uint32_t> words);

  VkShaderModule get() const { return module_.get(); }
  const ShaderInterface& interface() const { return interface_; }
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  ShaderInterface interface_;
  DeviceHandle<VkShaderModule> module_;
};

}  // namespace tetralux::gpu
