#include "render/target.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <glm/packing.hpp>

#include "base/check.h"
#include "base/error.h"
#include "shared/limits.h"

namespace tetralux::render {
namespace {

// Errors of 32 chunks stay below half an 8-bit level for up to 5000 cells behind each other; of smaller chunks there is
// nothing to gain, and each costs a pass over the picture.
constexpr std::uint32_t kChunks = 32;
constexpr std::uint32_t kFewestChunkCells = 64;
constexpr std::uint32_t kMostChunks = 256;

template <typename Packed>
Packed load(const std::byte* pixel) {
  Packed value;
  std::memcpy(&value, pixel, sizeof value);
  return value;
}

}  // namespace

const std::vector<std::string>& targetNames() {
  static const std::vector<std::string> names = {"rgba32f", "rgba16f",      "rgba16f-chunked",
                                                 "rgba8",   "rgba8-dither", "auto"};
  return names;
}

const char* targetName(Target target) { return targetNames()[static_cast<size_t>(target)].c_str(); }

Target parseTarget(const std::string& name) {
  const auto& names = targetNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    fail(ErrorCode::Usage, "--target: found '{}', expected one of {}", name, fmt::join(names, ", "));
  return static_cast<Target>(found - names.begin());
}

VkFormat pictureFormat(Target target) {
  switch (target) {
    case Target::Rgba16f:
      return VK_FORMAT_R16G16B16A16_SFLOAT;
    case Target::Rgba8:
    case Target::Rgba8Dither:
      return VK_FORMAT_R8G8B8A8_UNORM;
    case Target::Rgba32f:
    case Target::Rgba16fChunked:
      return VK_FORMAT_R32G32B32A32_SFLOAT;
    case Target::Auto:
      break;
  }
  CHECK(target != Target::Auto);
  return VK_FORMAT_UNDEFINED;
}

std::uint32_t bytesPerPixel(VkFormat pictureFormat) {
  return pictureFormat == VK_FORMAT_R8G8B8A8_UNORM ? 4 : pictureFormat == VK_FORMAT_R16G16B16A16_SFLOAT ? 8 : 16;
}

glm::vec4 unpackPixel(VkFormat pictureFormat, const std::byte* pixel) {
  switch (pictureFormat) {
    case VK_FORMAT_R8G8B8A8_UNORM:
      return glm::unpackUnorm4x8(load<std::uint32_t>(pixel));
    case VK_FORMAT_R16G16B16A16_SFLOAT:
      return glm::unpackHalf4x16(load<std::uint64_t>(pixel));
    default:
      return load<glm::vec4>(pixel);
  }
}

std::uint32_t chunkCellCount(std::uint32_t wanted, std::uint32_t cellCount) {
  const auto part = [&](std::uint32_t chunks) { return cellCount / chunks + 1; };
  const std::uint32_t chosen = wanted > 0 ? wanted : std::max(part(kChunks), kFewestChunkCells);
  return std::min(std::max(chosen, part(kMostChunks)), shared::BATCH_CELLS);
}

}  // namespace tetralux::render
