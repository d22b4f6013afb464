// Instance, device and queue.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/devices.h"
#include "gpu/memory_budget.h"
#include "gpu/vulkan.h"

namespace tetralux::gpu {

class Buffer;

struct ContextOptions {
  // A device's index, or a part of its name (case ignored). Empty: the first usable one of the best type (discrete,
  // integrated, virtual, CPU).
  std::string device;
  // Core and synchronisation validation; messages go to takeValidationMessages(). Throws Error(Device) where the
  // Khronos layer is not installed.
  bool validation = false;
  // Taken for MemoryBudget::availableBytes, whatever the driver says: for tests of what does not fit.
  std::optional<std::uint64_t> availableBytes{};
};

// Lives longer than everything made from it. Not thread-safe.
class Context {
 public:
  // Throws Error(Device): no Vulkan loader, no device, none that matches, or one that lacks a feature (named).
  explicit Context(const ContextOptions& options = {});
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  VkDevice device() const { return device_; }
  VkPhysicalDevice physicalDevice() const { return physicalDevice_; }
  VkQueue queue() const { return queue_; }
  VkCommandPool commandPool() const { return commandPool_; }
  const DeviceInfo& info() const { return info_; }
  // Nanoseconds per tick of a timestamp.
  float timestampPeriodNs() const { return timestampPeriodNs_; }
  bool validation() const { return validation_; }
  // Of the device's memory, as of now.
  MemoryBudget memoryBudget() const;

  // Index of the memory type with all wanted properties, or of the best without `preferred`.
  // Throws Error(Device) when no type has the required ones.
  std::uint32_t memoryType(std::uint32_t allowedTypes, VkMemoryPropertyFlags required,
                           VkMemoryPropertyFlags preferred) const;

  // What up to kSmallBytes (gpu/buffer.h) come back through; busy while download() runs.
  const Buffer& smallReadback() const { return *smallReadback_; }

  // Gives an object a name that validation messages and debuggers show. Nothing without validation.
  void setName(VkObjectType type, std::uint64_t handle, const std::string& name) const;

 private:
  void createInstance(bool validation);
  void chooseDevice(const std::string& wanted);
  void createDevice();
  void destroy();

  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  // Kept from this instance: volk's global pointers are those of the last instance made, which may lack the extension.
  PFN_vkDestroyDebugUtilsMessengerEXT destroyMessenger_ = nullptr;
  PFN_vkSetDebugUtilsObjectNameEXT setObjectName_ = nullptr;
  VkPhysicalDevice physicalDevice_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool commandPool_ = VK_NULL_HANDLE;
  std::uint32_t queueFamily_ = 0;
  DeviceInfo info_;
  float timestampPeriodNs_ = 1.0f;
  bool validation_ = false;
  std::optional<std::uint64_t> availableBytes_;
  std::unique_ptr<Buffer> smallReadback_;
};

// All devices that Vulkan knows on this machine. Throws Error(Device) when there is no loader.
std::vector<DeviceInfo> listDevices();

}  // namespace tetralux::gpu
