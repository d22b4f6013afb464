#include "gpu/commands.h"

#include <algorithm>
#include <chrono>
#include <type_traits>
#include <vector>

#include "base/check.h"

namespace tetralux::gpu {
namespace {

constexpr VkImageSubresourceRange kWholeColor{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};

VkBufferImageCopy wholeImage(const ImageExtent& extent) {
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {extent.width, extent.height, std::max(extent.depth, 1u)};
  return region;
}

}  // namespace

GroupCount groupCount(std::uint64_t threads, std::uint32_t workgroupSize) {
  const std::uint64_t groups = (threads + workgroupSize - 1) / workgroupSize;
  constexpr std::uint64_t kLargestX = 65535;  // the least maxComputeWorkGroupCount that Vulkan allows
  const std::uint64_t y = (groups + kLargestX - 1) / kLargestX;
  const std::uint64_t x = y == 0 ? 0 : (groups + y - 1) / y;
  CHECK_LE(y, kLargestX);
  return {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)};
}

CommandBuffer::CommandBuffer(const Context& context) : context_(&context) {
  VkCommandBufferAllocateInfo allocateInfo{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocateInfo.commandPool = context.commandPool();
  allocateInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocateInfo.commandBufferCount = 1;
  VK_CHECK(vkAllocateCommandBuffers(context.device(), &allocateInfo, &commands_));
  VkCommandBufferBeginInfo beginInfo{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  beginInfo.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  VK_CHECK(vkBeginCommandBuffer(commands_, &beginInfo));
}

CommandBuffer::~CommandBuffer() { vkFreeCommandBuffers(context_->device(), context_->commandPool(), 1, &commands_); }

void CommandBuffer::barrier(const Access& from, const Access& to) {
  VkMemoryBarrier2 memory{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  memory.srcStageMask = from.stages;
  memory.srcAccessMask = from.access;
  memory.dstStageMask = to.stages;
  memory.dstAccessMask = to.access;
  VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  info.memoryBarrierCount = 1;
  info.pMemoryBarriers = &memory;
  vkCmdPipelineBarrier2(commands_, &info);
}

void CommandBuffer::bind(VkPipelineBindPoint point, VkPipeline pipeline, const PipelineLayout& layout,
                         std::span<const Descriptor> descriptors, const void* push, size_t pushBytes) {
  const auto& bindings = layout.bindings();
  CHECK_EQ(descriptors.size(), bindings.size());
  vkCmdBindPipeline(commands_, point, pipeline);
  std::vector<VkWriteDescriptorSet> writes(bindings.size(), {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET});
  std::vector<VkDescriptorBufferInfo> buffers(bindings.size());
  std::vector<VkDescriptorImageInfo> images(bindings.size());
  for (std::uint32_t i = 0; i < bindings.size(); i++) {
    const Descriptor& d = descriptors[i];
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
    writes[i].descriptorType = bindings[i];
    if (bindings[i] == VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER) {
      CHECK(d.view_ != VK_NULL_HANDLE);
      writes[i].pTexelBufferView = &d.view_;
    } else if (bindings[i] == VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE ||
               bindings[i] == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER) {
      CHECK(d.image_ != VK_NULL_HANDLE);
      images[i] = {d.sampler_, d.image_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
      writes[i].pImageInfo = &images[i];
    } else {
      CHECK(d.buffer_ != nullptr);
      // A longer buffer is reached by its address (wide addressing); the descriptor then only has to be valid.
      const std::uint64_t range = std::min(d.buffer_->sizeBytes(), context_->info().largestStorageRangeBytes);
      buffers[i] = {d.buffer_->get(), 0, range};
      writes[i].pBufferInfo = &buffers[i];
    }
  }
  if (!writes.empty())
    vkCmdPushDescriptorSetKHR(commands_, point, layout.get(), 0, static_cast<std::uint32_t>(writes.size()),
                              writes.data());
  if (layout.pushConstantBytes() > 0) {
    // C++ pads a structure to its alignment, GLSL ends it with its last member.
    const auto padded = [](size_t bytes) { return (bytes + 7) / 8 * 8; };
    CHECK_EQ(padded(pushBytes), padded(layout.pushConstantBytes()));
    vkCmdPushConstants(commands_, layout.get(), layout.stages(), 0, layout.pushConstantBytes(), push);
  }
}

void CommandBuffer::dispatchGroups(const ComputePipeline& pipeline, std::uint64_t threads) {
  const GroupCount groups = groupCount(threads, pipeline.workgroupSize());
  if (groups.x > 0) vkCmdDispatch(commands_, groups.x, groups.y, 1);
}

void CommandBuffer::beginRendering(const AttachmentImage& image, bool clear, Rows rows) {
  VkRenderingAttachmentInfo attachment{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  attachment.imageView = image.view();
  attachment.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  attachment.loadOp = clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
  attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea = {{0, 0}, {image.width(), image.height()}};
  info.layerCount = 1;
  info.colorAttachmentCount = 1;
  info.pColorAttachments = &attachment;
  vkCmdBeginRendering(commands_, &info);
  setArea(image.width(), image.height(), rows);
}

void CommandBuffer::beginRendering(std::uint32_t width, std::uint32_t height, Rows rows) {
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea = {{0, 0}, {width, height}};
  info.layerCount = 1;
  vkCmdBeginRendering(commands_, &info);
  setArea(width, height, rows);
}

void CommandBuffer::setArea(std::uint32_t width, std::uint32_t height, Rows rows) {
  // Vulkan's ndc y points down and ours up; a viewport of negative height turns it round.
  const VkViewport viewport{
      0.0f, static_cast<float>(height), static_cast<float>(width), -static_cast<float>(height), 0.0f, 1.0f};
  const VkRect2D scissor{{0, static_cast<std::int32_t>(rows.first)}, {width, rows.count}};
  vkCmdSetViewport(commands_, 0, 1, &viewport);
  vkCmdSetScissor(commands_, 0, 1, &scissor);
}

void CommandBuffer::endRendering() { vkCmdEndRendering(commands_); }

void CommandBuffer::bindVertices(std::span<const Buffer* const> streams, const Buffer& indices) {
  std::vector<VkBuffer> buffers;
  for (const Buffer* stream : streams) buffers.push_back(stream->get());
  const std::vector<VkDeviceSize> offsets(buffers.size(), 0);
  if (!buffers.empty())
    vkCmdBindVertexBuffers(commands_, 0, static_cast<std::uint32_t>(buffers.size()), buffers.data(), offsets.data());
  vkCmdBindIndexBuffer(commands_, indices.get(), 0, VK_INDEX_TYPE_UINT32);
}

void CommandBuffer::imageBarrier(VkImage image, VkImageLayout from, VkImageLayout to, const Access& before,
                                 const Access& after) {
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = before.stages;
  barrier.srcAccessMask = before.access;
  barrier.dstStageMask = after.stages;
  barrier.dstAccessMask = after.access;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = kWholeColor;
  VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  info.imageMemoryBarrierCount = 1;
  info.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands_, &info);
}

void CommandBuffer::prepareAttachment(const AttachmentImage& image) {
  imageBarrier(image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
               access::kColorWrite | access::kTransferRead | access::kFragmentReadWrite, access::kColorWrite);
}

void CommandBuffer::prepareSampling(const AttachmentImage& image) {
  imageBarrier(image.get(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
               access::kColorWrite, access::kFragmentReadWrite);
}

void CommandBuffer::copyToBuffer(const AttachmentImage& image, const Buffer& buffer) {
  imageBarrier(image.get(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
               access::kColorWrite, access::kTransferRead);
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {image.width(), image.height(), 1};
  vkCmdCopyImageToBuffer(commands_, image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.get(), 1, &region);
  imageBarrier(image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
               access::kTransferRead, access::kColorWrite);
}

void CommandBuffer::copyToAttachment(const Buffer& buffer, const AttachmentImage& image, Rows rows) {
  imageBarrier(image.get(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
               access::kColorWrite, access::kTransferWrite);
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageOffset = {0, static_cast<std::int32_t>(rows.first), 0};
  region.imageExtent = {image.width(), rows.count, 1};
  vkCmdCopyBufferToImage(commands_, buffer.get(), image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
  imageBarrier(image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
               access::kTransferWrite, access::kColorWrite);
}

void CommandBuffer::copy(const Buffer& from, std::uint64_t fromOffset, const Buffer& to, std::uint64_t toOffset,
                         std::uint64_t bytes) {
  const VkBufferCopy region{fromOffset, toOffset, bytes};
  vkCmdCopyBuffer(commands_, from.get(), to.get(), 1, &region);
}

void CommandBuffer::fill(const Buffer& buffer, std::uint32_t value) { fill(buffer, value, 0, VK_WHOLE_SIZE); }

void CommandBuffer::fill(const Buffer& buffer, std::uint32_t value, std::uint64_t offsetBytes,
                         std::uint64_t sizeBytes) {
  vkCmdFillBuffer(commands_, buffer.get(), offsetBytes, sizeBytes, value);
}

void CommandBuffer::copyToImage(const Buffer& buffer, const SampledImage& image) {
  imageBarrier(image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, access::kAnyRead,
               access::kTransferWrite);
  const VkBufferImageCopy region = wholeImage(image.extent());
  vkCmdCopyBufferToImage(commands_, buffer.get(), image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
  imageBarrier(image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
               access::kTransferWrite, access::kAnyRead);
}

void CommandBuffer::copyToBuffer(const SampledImage& image, const Buffer& buffer) {
  imageBarrier(image.get(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
               access::kAnyRead, access::kTransferRead);
  const VkBufferImageCopy region = wholeImage(image.extent());
  vkCmdCopyImageToBuffer(commands_, image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.get(), 1, &region);
  imageBarrier(image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
               access::kTransferRead, access::kAnyRead);
}

void CommandBuffer::update(const Buffer& buffer, const void* data, std::uint64_t sizeBytes, std::uint64_t offsetBytes) {
  CHECK_LE(offsetBytes + sizeBytes, buffer.sizeBytes());
  constexpr std::uint64_t kLargest = 65536;  // that Vulkan takes at once
  for (std::uint64_t done = 0; done < sizeBytes; done += kLargest)
    vkCmdUpdateBuffer(commands_, buffer.get(), offsetBytes + done, std::min(kLargest, sizeBytes - done),
                      static_cast<const char*>(data) + done);
}

void CommandBuffer::submit() {
  VK_CHECK(vkEndCommandBuffer(commands_));
  VkFenceCreateInfo fenceInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  VkFence fence = VK_NULL_HANDLE;
  VK_CHECK(vkCreateFence(context_->device(), &fenceInfo, nullptr, &fence));
  fence_ = {context_->device(), fence, vkDestroyFence};
  VkCommandBufferSubmitInfo commandInfo{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  commandInfo.commandBuffer = commands_;
  VkSubmitInfo2 info{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  info.commandBufferInfoCount = 1;
  info.pCommandBufferInfos = &commandInfo;
  VK_CHECK(vkQueueSubmit2(context_->queue(), 1, &info, fence));
}

void CommandBuffer::wait() {
  const VkFence fence = fence_.get();
  VK_CHECK(vkWaitForFences(context_->device(), 1, &fence, VK_TRUE, UINT64_MAX));
}

double CommandBuffer::submitAndWait() {
  const auto start = std::chrono::steady_clock::now();
  submit();
  wait();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void waitUntilIdle(const Context& context) { VK_CHECK(vkQueueWaitIdle(context.queue())); }

}  // namespace tetralux::gpu
