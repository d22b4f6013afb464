#include "render/batch.h"

#include <algorithm>
#include <array>
#include <span>

namespace tetralux::render {
namespace {

using gpu::MemoryKind;

std::vector<std::uint32_t> patternIndices(std::uint32_t cells, std::span<const std::uint32_t> pattern) {
  std::vector<std::uint32_t> indices;
  indices.reserve(cells * pattern.size());
  for (std::uint32_t cell = 0; cell < cells; cell++) {
    for (const std::uint32_t vertex : pattern) indices.push_back(cell * shared::FAN_VERTICES + vertex);
  }
  return indices;
}

std::vector<std::uint32_t> cellIndices(std::uint32_t cells, bool outlines) {
  static constexpr std::array<std::uint32_t, shared::FAN_INDICES> kFan = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
  static constexpr std::array<std::uint32_t, shared::OUTLINE_INDICES> kOutline = {1, 2, 3, 1, 3, 4};
  return outlines ? patternIndices(cells, kOutline) : patternIndices(cells, kFan);
}

}  // namespace

BatchStorage::BatchStorage(const gpu::Context& context, std::uint32_t cellCount, CellProjection projection) {
  const std::uint32_t cells = std::min(cellCount, shared::BATCH_CELLS);
  const std::uint64_t vertices = std::uint64_t{cells} * shared::FAN_VERTICES;
  arguments = gpu::Buffer(context, sizeof(shared::BatchArguments), MemoryKind::Device, "batch arguments");
  indices = gpu::makeBuffer(context, cellIndices(cells, projection == CellProjection::Silhouette), "cell indices");
  if (projection == CellProjection::Gator) return;
  positions = gpu::Buffer(context, vertices * 8, MemoryKind::Device, "fan positions");
  ends = gpu::Buffer(context, vertices * 16, MemoryKind::Device, "fan ends");
  modes = gpu::Buffer(context, std::uint64_t{cells} * 4, MemoryKind::Device, "cell modes");
  endsView = gpu::TexelView(context, ends, VK_FORMAT_R32G32B32A32_SFLOAT);
  modesView = gpu::TexelView(context, modes, VK_FORMAT_R32_UINT);
}

std::uint64_t BatchStorage::sizeBytes() const {
  return arguments.sizeBytes() + positions.sizeBytes() + ends.sizeBytes() + modes.sizeBytes() + indices.sizeBytes();
}

}  // namespace tetralux::render
