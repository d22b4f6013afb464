#include "render/pixel_lists.h"

#include <algorithm>

namespace tetralux::render {
namespace {

using gpu::MemoryKind;

// Narrow bands keep the lists of the order small beside the mesh; drawing the boundary again for each costs little, as
// long as there are few of them. Drawing cells again costs more.
constexpr std::uint64_t kFewestBandPixels = std::uint64_t{1} << 16;
constexpr std::uint64_t kMostBands = 16;
constexpr std::uint64_t kColoredBandPixels = std::uint64_t{1} << 20;
constexpr std::uint32_t kFewestNodes = 1u << 16;
// Buffers of up to 64 MiB, which every device's descriptors reach.
constexpr std::uint32_t kMostNodes = 1u << 22;

}  // namespace

PixelLists::PixelLists(const gpu::Context& context, ImageSize size, bool withColors)
    : context_(&context), size_(size), withColors_(withColors) {
  const std::uint64_t pixels = std::uint64_t{size.width} * size.height;
  const std::uint64_t mostPixels = withColors ? kColoredBandPixels : std::max(kFewestBandPixels, pixels / kMostBands);
  bandRows_ = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(mostPixels / size.width, 1, size.height));
  // A ray enters and leaves most meshes once; cycles cover a small part of the picture.
  const std::uint64_t nodes = withColors ? bandPixels() / 4 : 2 * bandPixels();
  capacity_ = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(nodes, kFewestNodes, kMostNodes));
  allocate();
}

void PixelLists::allocate() {
  // The old buffers go first: both may not fit.
  for (gpu::Buffer* buffer : {&heads_, &links_, &ranks_, &colors_, &counts_}) *buffer = {};
  heads_ = gpu::Buffer(*context_, 4 * bandPixels(), MemoryKind::Device, "pixel heads");
  links_ = gpu::Buffer(*context_, std::uint64_t{4} * capacity_, MemoryKind::Device, "pixel links");
  ranks_ = gpu::Buffer(*context_, std::uint64_t{8} * capacity_, MemoryKind::Device, "pixel ranks");
  colors_ = gpu::Buffer(*context_, withColors_ ? std::uint64_t{16} * capacity_ : 4, MemoryKind::Device, "pixel colors");
  counts_ = gpu::Buffer(*context_, std::uint64_t{4} * bandCount(), MemoryKind::Device, "pixel counts");
}

shared::PixelBand PixelLists::band(std::uint32_t index) const {
  const std::uint32_t first = index * bandRows_;
  return {size_.width, first, std::min(bandRows_, size_.height - first), index, capacity_};
}

shared::PixelBand PixelLists::bandFrom(std::uint32_t firstRow) const {
  return {size_.width, firstRow, std::min(bandRows_, size_.height - firstRow), 0, capacity_};
}

bool PixelLists::grow() {
  const auto counts = gpu::downloadVector<std::uint32_t>(*context_, counts_, bandCount());
  const std::uint32_t wanted = *std::max_element(counts.begin(), counts.end());
  if (wanted <= capacity_) return false;
  if (wanted <= kMostNodes || bandRows_ == 1) {
    // A quarter more: the next frame of a sequence is a little different.
    capacity_ = static_cast<std::uint32_t>(std::min<std::uint64_t>(wanted + std::uint64_t{wanted} / 4, 0xfffffffeu));
    if (bandRows_ > 1) capacity_ = std::min(capacity_, kMostNodes);
  } else {
    capacity_ = kMostNodes;
    const std::uint32_t parts = wanted / kMostNodes + 1;
    bandRows_ = std::max(1u, std::min(bandRows_ / 2, bandRows_ / parts));
  }
  allocate();
  return true;
}

std::uint64_t PixelLists::sizeBytes() const {
  return heads_.sizeBytes() + links_.sizeBytes() + ranks_.sizeBytes() + colors_.sizeBytes() + counts_.sizeBytes();
}

}  // namespace tetralux::render
