#include "render/march_storage.h"

namespace tetralux::render {

MarchStorage::MarchStorage(const gpu::Context& context, const Adjacency& adjacency)
    : context_(context),
      topology_(context, adjacency, /*overlaps=*/{}),
      view_(context, sizeof(shared::FrameView), gpu::MemoryKind::Device, "frame view"),
      unfinished_(context, sizeof(std::uint32_t), gpu::MemoryKind::Device, "unfinished rays") {}

void MarchStorage::prepare(ImageSize size) {
  if (lists_ && lists_->size().width == size.width && lists_->size().height == size.height) return;
  lists_.reset();
  colorsView_ = {};
  colors_ = {};
  lists_ = std::make_unique<PixelLists>(context_, size, /*withColors=*/false);
  colors_ = gpu::Buffer(context_, 16 * lists_->bandPixels(), gpu::MemoryKind::Device, "march colors");
  colorsView_ = gpu::TexelView(context_, colors_, VK_FORMAT_R32G32B32A32_SFLOAT);
}

std::uint64_t MarchStorage::sizeBytes() const {
  return topology_.sizeBytes() + view_.sizeBytes() + unfinished_.sizeBytes() + (lists_ ? lists_->sizeBytes() : 0) +
         colors_.sizeBytes();
}

}  // namespace tetralux::render
