// What cells are blended into.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "gpu/image.h"

namespace tetralux::render {

enum class Target {
  Rgba32f,
  Rgba16f,  // half the memory; wrong by several 8-bit levels where more than about 20 thin cells lie behind each other
  Rgba16fChunked,  // chunks of cells are blended into 16-bit floats, the chunks into 32-bit floats
  Rgba8,           // 8 bits a channel; layers of an opacity below 1/510 vanish
  Rgba8Dither,     // ... with every layer rounded up or down at random (Kraus, Qiao and Ebert 2004, section 4.2)
  Auto,            // Rgba16f where roundings are measured to stay below 1/512, else Rgba32f
};

// Names on the command line and in statistics, in the order above; parseTarget throws Error(Usage).
const std::vector<std::string>& targetNames();
const char* targetName(Target target);
Target parseTarget(const std::string& name);

// Format of the picture; not for Auto.
VkFormat pictureFormat(Target target);

// Pixels of a picture, 16, 8 or 4 bytes each.
std::uint32_t bytesPerPixel(VkFormat pictureFormat);
// The pixel as floats, from its bytes.
glm::vec4 unpackPixel(VkFormat pictureFormat, const std::byte* pixel);

// Cells to a chunk of Rgba16fChunked.
//   wanted   0: a 32nd of the mesh's cells, at least 64
// So many that there are no more than 256 chunks, but never more than BATCH_CELLS.
std::uint32_t chunkCellCount(std::uint32_t wanted, std::uint32_t cellCount);

}  // namespace tetralux::render
