#include "render/target_images.h"

#include "base/check.h"

namespace tetralux::render {

bool TargetImages::holds(ImageSize size, Target target) const {
  return picture_ && picture_->width() == size.width && picture_->height() == size.height &&
         picture_->format() == pictureFormat(target) && (chunk_ != nullptr) == (target == Target::Rgba16fChunked);
}

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
  if (!readback_)
    readback_ = std::make_unique<gpu::Buffer>(context_, pictureBytes(), gpu::MemoryKind::Readback, "readback");
  gpu::CommandBuffer commands(context_);
  recordRead(commands, *readback_);
  const double copyMs = commands.submitAndWait();
  if (milliseconds) *milliseconds = copyMs;
  return unpack(*readback_);
}

void TargetImages::recordRead(gpu::CommandBuffer& commands, const gpu::Buffer& readback) const {
  commands.copyToBuffer(*picture_, readback);
  commands.barrier(gpu::access::kTransferWrite, gpu::access::kHostRead);
}

Image TargetImages::unpack(const gpu::Buffer& readback) const {
  const VkFormat format = picture_->format();
  if (format == VK_FORMAT_R32G32B32A32_SFLOAT) {
    // Copied into memory that nobody has filled with zeros before: a large picture's is touched for the first time.
    Image image;
    image.width = picture_->width();
    image.height = picture_->height();
    const auto pixels = readback.as<glm::vec4>().first(std::size_t{image.width} * image.height);
    image.pixels.assign(pixels.begin(), pixels.end());
    return image;
  }
  Image image(picture_->width(), picture_->height());
  const auto bytes = readback.as<std::byte>();
  const std::uint32_t pixelBytes = bytesPerPixel(format);
  for (size_t i = 0; i < image.pixels.size(); i++) image.pixels[i] = unpackPixel(format, bytes.data() + i * pixelBytes);
  return image;
}

std::uint64_t TargetImages::pictureBytes() const {
  return std::uint64_t{picture_->width()} * picture_->height() * bytesPerPixel(picture_->format());
}

std::uint64_t TargetImages::sizeBytes() const {
  return (picture_ ? picture_->sizeBytes() : 0) + (chunk_ ? chunk_->sizeBytes() : 0) +
         (readback_ ? readback_->sizeBytes() : 0);
}

}  // namespace tetralux::render
