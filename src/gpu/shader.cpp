#include "gpu/shader.h"

#include <algorithm>
#include <map>

#include "base/check.h"

namespace tetralux::gpu {
namespace {

// The few words of the SPIR-V specification (version 1.6) that the interface hangs on.
enum Op : std::uint32_t {
  OpEntryPoint = 15,
  OpExecutionMode = 16,
  OpTypeInt = 21,
  OpTypeFloat = 22,
  OpTypeVector = 23,
  OpTypeMatrix = 24,
  OpTypeImage = 25,
  OpTypeSampledImage = 27,
  OpTypeArray = 28,
  OpTypeStruct = 30,
  OpTypePointer = 32,
  OpConstant = 43,
  OpVariable = 59,
  OpDecorate = 71,
  OpMemberDecorate = 72,
  OpExecutionModeId = 331,
};
enum Decoration : std::uint32_t {
  DecorationArrayStride = 6,
  DecorationMatrixStride = 7,
  DecorationBuiltIn = 11,
  DecorationBinding = 33,
  DecorationOffset = 35
};
enum StorageClass : std::uint32_t {
  StorageUniformConstant = 0,
  StorageUniform = 2,
  StoragePushConstant = 9,
  StorageStorageBuffer = 12,
  StoragePhysicalStorageBuffer = 5349
};
constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::uint32_t kExecutionModeLocalSize = 17;
constexpr std::uint32_t kExecutionModeLocalSizeId = 38;
constexpr std::uint32_t kDimBuffer = 5;

struct Instruction {
  std::uint32_t op;
  std::span<const std::uint32_t> operands;
};

// Everything kept about one result id.
struct Id {
  Instruction type{0, {}};  // the instruction that made it
  std::uint32_t binding = ~0u;
  std::uint32_t arrayStride = 0;
  std::map<std::uint32_t, std::uint32_t> memberOffset;
  std::map<std::uint32_t, std::uint32_t> matrixStride;
};

class Module {
 public:
  explicit Module(std::span<const std::uint32_t> words) {
    CHECK(words.size() > 5 && words[0] == kMagic);
    ids_.resize(words[3]);
    for (size_t at = 5; at < words.size();) {
      const std::uint32_t length = words[at] >> 16;
      CHECK(length > 0 && at + length <= words.size());
      add({words[at] & 0xffff, words.subspan(at + 1, length - 1)});
      at += length;
    }
  }

  ShaderInterface interface() const {
    ShaderInterface result;
    result.stage = stage_;
    result.localSize = localSize_;
    for (size_t axis = 0; axis < localSizeIds_.size(); axis++)
      result.localSize[axis] = ids_[localSizeIds_[axis]].type.operands[2];
    for (const Instruction& variable : variables_) {
      const std::uint32_t id = variable.operands[1];
      const std::uint32_t storage = variable.operands[2];
      const std::uint32_t pointee = ids_[variable.operands[0]].type.operands[2];
      if (storage == StoragePushConstant)
        result.pushConstantBytes = sizeOf(pointee, ids_[pointee]);
      else if (ids_[id].binding != ~0u)
        result.bindings.push_back({ids_[id].binding, descriptorType(storage, pointee)});
    }
    std::sort(result.bindings.begin(), result.bindings.end(),
              [](const auto& a, const auto& b) { return a.number < b.number; });
    CHECK(stage_ != VK_SHADER_STAGE_COMPUTE_BIT || !localSizeIds_.empty() || localSize_ != decltype(localSize_){});
    return result;
  }

 private:
  void add(const Instruction& i) {
    switch (i.op) {
      case OpEntryPoint: {
        constexpr std::array<VkShaderStageFlagBits, 6> kStages = {VK_SHADER_STAGE_VERTEX_BIT,
                                                                  VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT,
                                                                  VK_SHADER_STAGE_TESSELLATION_EVALUATION_BIT,
                                                                  VK_SHADER_STAGE_GEOMETRY_BIT,
                                                                  VK_SHADER_STAGE_FRAGMENT_BIT,
                                                                  VK_SHADER_STAGE_COMPUTE_BIT};
        CHECK_LT(i.operands[0], kStages.size());
        stage_ = kStages[i.operands[0]];
        break;
      }
      case OpExecutionMode:
        if (i.operands[1] == kExecutionModeLocalSize) localSize_ = {i.operands[2], i.operands[3], i.operands[4]};
        break;
      case OpExecutionModeId:  // the constants come later in the module
        if (i.operands[1] == kExecutionModeLocalSizeId) localSizeIds_ = i.operands.subspan(2, 3);
        break;
      case OpTypeInt:
      case OpTypeFloat:
      case OpTypeVector:
      case OpTypeMatrix:
      case OpTypeImage:
      case OpTypeSampledImage:
      case OpTypeArray:
      case OpTypeStruct:
      case OpTypePointer:
        ids_[i.operands[0]].type = i;
        break;
      case OpConstant:
        ids_[i.operands[1]].type = i;
        break;
      case OpVariable:
        variables_.push_back(i);
        break;
      case OpDecorate:
        if (i.operands[1] == DecorationBinding) ids_[i.operands[0]].binding = i.operands[2];
        if (i.operands[1] == DecorationArrayStride) ids_[i.operands[0]].arrayStride = i.operands[2];
        break;
      case OpMemberDecorate:
        if (i.operands[2] == DecorationOffset) ids_[i.operands[0]].memberOffset[i.operands[1]] = i.operands[3];
        if (i.operands[2] == DecorationMatrixStride) ids_[i.operands[0]].matrixStride[i.operands[1]] = i.operands[3];
        break;
      default:
        break;
    }
  }

  VkDescriptorType descriptorType(std::uint32_t storage, std::uint32_t typeId) const {
    if (storage == StorageStorageBuffer) return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    if (storage == StorageUniform) return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    CHECK_EQ(storage, static_cast<std::uint32_t>(StorageUniformConstant));
    const Instruction& type = ids_[typeId].type;
    const Instruction& image = type.op == OpTypeSampledImage ? ids_[type.operands[1]].type : type;
    CHECK_EQ(image.op, static_cast<std::uint32_t>(OpTypeImage));
    const bool isBuffer = image.operands[2] == kDimBuffer;
    const bool isSampled = image.operands[6] == 1;
    if (isBuffer) return isSampled ? VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER;
    if (!isSampled) return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    return type.op == OpTypeSampledImage ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER : VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
  }

  // Bytes of a block's member; `owner` and `member` give the matrix stride, which belongs to the member.
  std::uint32_t sizeOf(std::uint32_t typeId, const Id& owner, std::uint32_t member = 0) const {
    const Id& id = ids_[typeId];
    const auto& operands = id.type.operands;
    switch (id.type.op) {
      case OpTypeInt:
      case OpTypeFloat:
        return operands[1] / 8;
      case OpTypeVector:
        return operands[2] * sizeOf(operands[1], owner);
      case OpTypeMatrix:
        return operands[2] * owner.matrixStride.at(member);
      case OpTypeArray:
        return id.arrayStride * ids_[operands[2]].type.operands[2];
      case OpTypePointer:
        CHECK_EQ(operands[1], static_cast<std::uint32_t>(StoragePhysicalStorageBuffer));
        return 8;
      case OpTypeStruct: {
        std::uint32_t end = 0;
        for (std::uint32_t m = 0; m + 1 < operands.size(); m++)
          end = std::max(end, id.memberOffset.at(m) + sizeOf(operands[m + 1], id, m));
        return end;
      }
      default:
        CHECK(!"type in a push constant block");
        return 0;
    }
  }

  std::vector<Id> ids_;
  std::vector<Instruction> variables_;
  VkShaderStageFlagBits stage_ = VK_SHADER_STAGE_ALL;
  std::array<std::uint32_t, 3> localSize_ = {};  // zero: not stated
  std::span<const std::uint32_t> localSizeIds_;
};

}  // namespace

ShaderInterface reflect(std::span<const std::uint32_t> words) { return Module(words).interface(); }

Shader::Shader(const Context& context, const std::string& name, std::span<const std::uint32_t> words)
    : name_(name), interface_(reflect(words)) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = words.size_bytes();
  info.pCode = words.data();
  VkShaderModule module = VK_NULL_HANDLE;
  VK_CHECK(vkCreateShaderModule(context.device(), &info, nullptr, &module));
  module_ = {context.device(), module, vkDestroyShaderModule};
  context.setName(VK_OBJECT_TYPE_SHADER_MODULE, reinterpret_cast<std::uint64_t>(module), name);
}

}  // namespace tetralux::gpu
