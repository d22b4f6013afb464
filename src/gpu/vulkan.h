// Vulkan with the entry points that volk loads, results as errors, and owners for handles.
#pragma once

#include <volk.h>

#include <utility>

namespace tetralux::gpu {

// "VK_ERROR_DEVICE_LOST", ...
const char* resultName(VkResult result);

// Throws Error(Device) unless the result is VK_SUCCESS.
void checkResult(VkResult result, const char* call, const char* file, int line);

// Owns one handle of a device and destroys it once. Empty by default; move-only.
template <typename Handle>
class DeviceHandle {
 public:
  using Destroy = void (*)(VkDevice, Handle, const VkAllocationCallbacks*);

  DeviceHandle() = default;
  DeviceHandle(VkDevice device, Handle handle, Destroy destroy) : device_(device), handle_(handle), destroy_(destroy) {}
  DeviceHandle(DeviceHandle&& other) noexcept { *this = std::move(other); }
  DeviceHandle& operator=(DeviceHandle&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    std::swap(destroy_, other.destroy_);
    return *this;
  }
  ~DeviceHandle() {
    if (handle_ != VK_NULL_HANDLE) destroy_(device_, handle_, nullptr);
  }
  DeviceHandle(const DeviceHandle&) = delete;
  DeviceHandle& operator=(const DeviceHandle&) = delete;

  Handle get() const { return handle_; }
  explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }

 private:
  VkDevice device_ = VK_NULL_HANDLE;
  Handle handle_ = VK_NULL_HANDLE;
  Destroy destroy_ = nullptr;
};

}  // namespace tetralux::gpu

// Active in every build. Only VK_SUCCESS passes.
#define VK_CHECK(call) ::tetralux::gpu::checkResult((call), #call, __FILE__, __LINE__)
