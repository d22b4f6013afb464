// The images of a target on the device.
#pragma once

#include <memory>

#include "gpu/commands.h"
#include "image/image.h"
#include "render/target.h"
#include "view/camera.h"

namespace tetralux::render {

// What a frame is drawn into.
struct FrameTarget {
  const gpu::AttachmentImage& picture;
  const gpu::AttachmentImage* chunk = nullptr;  // where not null, cells go here first, so many at a time:
  std::uint32_t chunkCells = 0;
};

class TargetImages {
 public:
  explicit TargetImages(const gpu::Context& context) : context_(context) {}

  // Makes images of this size and kind unless they are there already. The content is undefined. Not for Target::Auto.
  // Throws Error(Device) when the sides are beyond the device's limit or memory is short.
  void prepare(ImageSize size, Target target);

  // Whether prepare() would change nothing.
  bool holds(ImageSize size, Target target) const;

  // What prepare() made.
  const gpu::AttachmentImage& picture() const { return *picture_; }
  const gpu::AttachmentImage* chunk() const { return chunk_.get(); }
  bool isEmpty() const { return picture_ == nullptr; }

  // The picture on the host. Sets `milliseconds`, if given, to what the copy took.
  Image read(double* milliseconds = nullptr);

  // The same in two steps. Records a copy of the picture to a buffer of pictureBytes() that the host can read.
  void recordRead(gpu::CommandBuffer& commands, const gpu::Buffer& readback) const;
  // After that has run, and while prepare() has made no other kind of picture.
  Image unpack(const gpu::Buffer& readback) const;
  std::uint64_t pictureBytes() const;

  std::uint64_t sizeBytes() const;

 private:
  const gpu::Context& context_;
  std::unique_ptr<gpu::AttachmentImage> picture_;
  std::unique_ptr<gpu::AttachmentImage> chunk_;
  std::unique_ptr<gpu::Buffer> readback_;
};

}  // namespace tetralux::render
