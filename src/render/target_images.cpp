#include "render/target_images.h"

#include "base/check.h"

namespace tetralux::render {

void TargetImages::prepare(ImageSize size, Target target) {
  const VkFormat format = pictureFormat(target);
  const auto fits = [&](const gpu::AttachmentImage& image) {
    return image.width() == size.width && image.height() == size.height;
  };
  if (!picture_ || !fits(*picture_) || picture_->format() != format) {
    readback_.reset();
    picture_.reset();
    gpu::requireMemory(context_, std::uint64_t{size.width} * size.height * bytesPerPixel(format), "the picture");
    picture_ = std::make_unique<gpu::AttachmentImage>(context_, size.width, size.height, format, "target");
  }
  const bool isChunked = target == Target::Rgba16fChunked;
  if (chunk_ && (!isChunked || !fits(*chunk_))) chunk_.reset();
  if (isChunked && !chunk_)
    chunk_ = std::make_unique<gpu::AttachmentImage>(context_, size.width, size.height, VK_FORMAT_R16G16B16A16_SFLOAT,
                                                    "chunk", /*isSampled=*/true);
}

Image TargetImages::read(double* milliseconds) {
  CHECK(picture_ != nullptr);
  Image image(picture_->width(), picture_->height());
  const std::uint32_t pixelBytes = bytesPerPixel(picture_->format());
  if (!readback_)
    readback_ = std::make_unique<gpu::Buffer>(context_, image.pixels.size() * pixelBytes, gpu::MemoryKind::Readback,
                                              "readback");
  gpu::CommandBuffer commands(context_);
  commands.copyToBuffer(*picture_, *readback_);
  commands.barrier(gpu::access::kTransferWrite, gpu::access::kHostRead);
  const double copyMs = commands.submitAndWait();
  if (milliseconds) *milliseconds = copyMs;
  const auto bytes = readback_->as<std::byte>();
  for (size_t i = 0; i < image.pixels.size(); i++)
    image.pixels[i] = unpackPixel(picture_->format(), bytes.data() + i * pixelBytes);
  return image;
}

std::uint64_t TargetImages::sizeBytes() const {
  return (picture_ ? picture_->sizeBytes() : 0) + (chunk_ ? chunk_->sizeBytes() : 0) +
         (readback_ ? readback_->sizeBytes() : 0);
}

}  // namespace tetralux::render
