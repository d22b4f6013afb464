// The machine's Vulkan devices: what they are and whether tetralux can use them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gpu/memory_budget.h"
#include "gpu/vulkan.h"

namespace tetralux::gpu {

struct DeviceInfo {
  std::uint32_t index = 0;
  std::string name;
  std::string type;        // "discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"
  std::string driver;      // name and version, as the driver gives them
  std::string apiVersion;  // "1.3.230"
  bool isCpu = false;
  MemoryBudget memory;  // when the device was described
  std::uint64_t largestAllocationBytes = 0;
  std::uint64_t largestStorageRangeBytes = 0;  // maxStorageBufferRange
  std::uint64_t largestTexelBuffer = 0;        // elements, maxTexelBufferElements
  std::uint32_t largestImageSide = 0;          // pixels
  std::uint32_t subgroupSize = 0;
  bool hasFloat64 = false;         // double precision in shaders
  std::uint32_t subpixels = 0;     // steps per pixel to which vertices are snapped
  std::uint32_t subtexelBits = 0;  // of a sampler's fractions between texels
  std::string missing;             // what it lacks for tetralux, or empty when it can be used
};

// What a device must offer: the one list of it.
struct DeviceFeatures {
  VkPhysicalDeviceVulkan11Features vulkan11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
  VkPhysicalDeviceVulkan12Features vulkan12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan13Features vulkan13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};

  DeviceFeatures();
  DeviceFeatures(const DeviceFeatures&) = delete;
  DeviceFeatures& operator=(const DeviceFeatures&) = delete;

  // Switches on what tetralux needs.
  void require();
  // Switches on what it takes where a device has it.
  void take(const DeviceInfo& info);
  // Names of what `required` switches on and this one lacks, separated by ", ".
  std::string missing(const DeviceFeatures& required) const;
};

const std::vector<const char*>& requiredExtensions();

// Describes one device of an instance.
DeviceInfo describe(VkPhysicalDevice device, std::uint32_t index);

// All devices, in the driver's order.
std::vector<VkPhysicalDevice> physicalDevices(VkInstance instance);

}  // namespace tetralux::gpu
