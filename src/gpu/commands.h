// Recording and submitting work.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "gpu/pipeline.h"
#include "gpu/sampled_image.h"

namespace tetralux::gpu {

// A way of touching memory: the two halves of a barrier are named by these.
struct Access {
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 access = 0;

  friend Access operator|(const Access& a, const Access& b) { return {a.stages | b.stages, a.access | b.access}; }
};

namespace access {
inline constexpr Access kComputeWrite{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT};
inline constexpr Access kComputeRead{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_READ_BIT};
inline constexpr Access kComputeReadWrite{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                          VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT};
inline constexpr Access kIndirectRead{VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT};
inline constexpr Access kVertexRead{
    VK_PIPELINE_STAGE_2_VERTEX_INPUT_BIT | VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT |
        VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
    VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT | VK_ACCESS_2_INDEX_READ_BIT | VK_ACCESS_2_SHADER_READ_BIT};
inline constexpr Access kFragmentReadWrite{VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
                                           VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_SHADER_WRITE_BIT};
inline constexpr Access kColorWrite{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
inline constexpr Access kTransferWrite{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
inline constexpr Access kTransferRead{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
inline constexpr Access kHostRead{VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT};
inline constexpr Access kAnyWrite{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT};
inline constexpr Access kAnyRead{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                 VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};
}  // namespace access

// Rows of an image, from the top.
struct Rows {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

// What a binding is bound to: a buffer (storage or uniform, as the shader declares), a texel view, an image prepared
// for sampling, or an image with its sampler.
class Descriptor {
 public:
  Descriptor(const Buffer& buffer) : buffer_(&buffer) {}              // NOLINT(google-explicit-constructor)
  Descriptor(const TexelView& view) : view_(view.get()) {}            // NOLINT(google-explicit-constructor)
  Descriptor(const AttachmentImage& image) : image_(image.view()) {}  // NOLINT(google-explicit-constructor)
  Descriptor(const SampledImage& image)                               // NOLINT(google-explicit-constructor)
      : image_(image.view()), sampler_(image.sampler()) {}

 private:
  friend class CommandBuffer;
  const Buffer* buffer_ = nullptr;
  VkBufferView view_ = VK_NULL_HANDLE;
  VkImageView image_ = VK_NULL_HANDLE;
  VkSampler sampler_ = VK_NULL_HANDLE;
};

using Descriptors = std::vector<Descriptor>;

// A primary command buffer, recording from its construction on; submitted at most once. Everything recorded must
// outlive its execution.
class CommandBuffer {
 public:
  explicit CommandBuffer(const Context& context);
  ~CommandBuffer();
  CommandBuffer(const CommandBuffer&) = delete;
  CommandBuffer& operator=(const CommandBuffer&) = delete;

  VkCommandBuffer get() const { return commands_; }

  // Waits in `to` for all memory writes of `from`.
  void barrier(const Access& from, const Access& to);

  // Runs at least `threads` invocations; shaders find their index with linearIndex() (include/dispatch.glsl) and
  // ignore those beyond their count. Descriptors in the order of the bindings; their number and the push constants'
  // size must be what the shader declares.
  template <typename Push>
  void dispatch(const ComputePipeline& pipeline, const Descriptors& descriptors, const Push& push,
                std::uint64_t threads) {
    bind(VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get(), pipeline.layout(), descriptors, &push, sizeof push);
    dispatchGroups(pipeline, threads);
  }
  // The same with the number of workgroups (VkDispatchIndirectCommand) read from a buffer.
  template <typename Push>
  void dispatchIndirect(const ComputePipeline& pipeline, const Descriptors& descriptors, const Push& push,
                        const Buffer& arguments, std::uint64_t offsetBytes) {
    bind(VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get(), pipeline.layout(), descriptors, &push, sizeof push);
    vkCmdDispatchIndirect(commands_, arguments.get(), offsetBytes);
  }

  // Between beginRendering and endRendering: one attachment, cleared to zero or kept, of which only some rows are
  // drawn.
  void beginRendering(const AttachmentImage& image, bool clear) { beginRendering(image, clear, {0, image.height()}); }
  void beginRendering(const AttachmentImage& image, bool clear, Rows rows);
  // The same without an attachment: fragment shaders write to buffers.
  void beginRendering(std::uint32_t width, std::uint32_t height, Rows rows);
  void endRendering();
  // Triangles without vertex buffers.
  template <typename Push>
  void draw(const GraphicsPipeline& pipeline, const Descriptors& descriptors, const Push& push,
            std::uint32_t vertexCount) {
    bind(VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.get(), pipeline.layout(), descriptors, &push, sizeof push);
    vkCmdDraw(commands_, vertexCount, 1, 0, 0);
  }
  template <typename Push>
  void drawIndexedIndirect(const GraphicsPipeline& pipeline, std::span<const Descriptor> descriptors, const Push& push,
                           std::span<const Buffer* const> vertexStreams, const Buffer& indices, const Buffer& arguments,
                           std::uint64_t offsetBytes) {
    bind(VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.get(), pipeline.layout(), descriptors, &push, sizeof push);
    bindVertices(vertexStreams, indices);
    vkCmdDrawIndexedIndirect(commands_, arguments.get(), offsetBytes, 1, 0);
  }

  // Attachment images are kept in one layout, ready for rendering, after this. Their content is forgotten.
  void prepareAttachment(const AttachmentImage& image);
  // What was rendered can be read by fragment shaders after this, until the image is prepared for rendering again.
  void prepareSampling(const AttachmentImage& image);
  // Copies a whole attachment to a buffer, tightly packed, row 0 first. The attachment is ready for rendering again.
  void copyToBuffer(const AttachmentImage& image, const Buffer& buffer);
  // The other way: some rows of an attachment that is ready for rendering, from a buffer of their pixels.
  void copyToAttachment(const Buffer& buffer, const AttachmentImage& image, Rows rows);
  void copy(const Buffer& from, std::uint64_t fromOffset, const Buffer& to, std::uint64_t toOffset,
            std::uint64_t bytes);
  void fill(const Buffer& buffer, std::uint32_t value);
  // Only some of it; offset and size in multiples of 4.
  void fill(const Buffer& buffer, std::uint32_t value, std::uint64_t offsetBytes, std::uint64_t sizeBytes);
  // Fills a sampled image from a buffer of its texels, tightly packed, row 0 of slice 0 first. The image can be read by
  // shaders after it; writes of the buffer need a barrier to kTransferRead before.
  void copyToImage(const Buffer& buffer, const SampledImage& image);
  // The same back; the image must have been filled, and can be read by shaders again.
  void copyToBuffer(const SampledImage& image, const Buffer& buffer);

  // Overwrites some of a buffer with little: the data are taken from `data` now, and travel with the commands.
  //   sizeBytes   a multiple of 4, like the offset
  void update(const Buffer& buffer, const void* data, std::uint64_t sizeBytes, std::uint64_t offsetBytes = 0);

  // Ends recording and hands everything to the device. wait() is owed.
  void submit();
  // Waits until what was submitted has run.
  void wait();
  // Both. Returns the wall time of submission and wait, ms.
  double submitAndWait();

 private:
  void bind(VkPipelineBindPoint point, VkPipeline pipeline, const PipelineLayout& layout,
            std::span<const Descriptor> descriptors, const void* push, size_t pushBytes);
  void bind(VkPipelineBindPoint point, VkPipeline pipeline, const PipelineLayout& layout,
            const Descriptors& descriptors, const void* push, size_t pushBytes) {
    bind(point, pipeline, layout, std::span(descriptors.begin(), descriptors.size()), push, pushBytes);
  }
  void dispatchGroups(const ComputePipeline& pipeline, std::uint64_t threads);
  void bindVertices(std::span<const Buffer* const> streams, const Buffer& indices);
  void setArea(std::uint32_t width, std::uint32_t height, Rows rows);
  void imageBarrier(VkImage image, VkImageLayout from, VkImageLayout to, const Access& before, const Access& after);

  const Context* context_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  DeviceHandle<VkFence> fence_;
};

// Waits until the device has nothing left to do.
void waitUntilIdle(const Context& context);

// Push constants of a shader that has none.
struct NoPush {};

// Number of workgroups along x and y for a number of invocations: x is limited to what every device allows.
struct GroupCount {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
};
GroupCount groupCount(std::uint64_t threads, std::uint32_t workgroupSize);

}  // namespace tetralux::gpu
