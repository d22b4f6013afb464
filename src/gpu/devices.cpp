#include "gpu/devices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace tetralux::gpu {
namespace {

const char* typeName(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "discrete GPU";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated GPU";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual GPU";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "CPU";
    default:
      return "other";
  }
}

std::string missingExtensions(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  VK_CHECK(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr));
  std::vector<VkExtensionProperties> available(count);
  VK_CHECK(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, available.data()));
  std::string missing;
  for (const char* name : requiredExtensions()) {
    const bool found = std::any_of(available.begin(), available.end(), [&](const VkExtensionProperties& e) {
      return std::strcmp(e.extensionName, name) == 0;
    });
    if (!found) missing += fmt::format("{}{}", missing.empty() ? "" : ", ", name);
  }
  return missing;
}

// Blending into 32-bit floats is optional in Vulkan; without it there is no accurate frame.
bool blendsFloat32(VkPhysicalDevice device) {
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(device, VK_FORMAT_R32G32B32A32_SFLOAT, &properties);
  return (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT) != 0;
}

}  // namespace

const std::vector<const char*>& requiredExtensions() {
  static const std::vector<const char*> names = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
  return names;
}

DeviceFeatures::DeviceFeatures() {
  features.pNext = &vulkan11;
  vulkan11.pNext = &vulkan12;
  vulkan12.pNext = &vulkan13;
}

void DeviceFeatures::require() {
  features.features.fragmentStoresAndAtomics = VK_TRUE;  // lists of fragments per pixel
  vulkan12.bufferDeviceAddress = VK_TRUE;                // buffers beyond the range limit of a descriptor
  vulkan12.scalarBlockLayout = VK_TRUE;                  // one layout for C++ and GLSL
  vulkan13.dynamicRendering = VK_TRUE;
  vulkan13.synchronization2 = VK_TRUE;
  vulkan13.maintenance4 = VK_TRUE;  // largest buffer size, local sizes by specialisation
  vulkan13.subgroupSizeControl = VK_TRUE;
}

void DeviceFeatures::take(const DeviceInfo& info) {
  features.features.shaderFloat64 = info.hasFloat64 ? VK_TRUE : VK_FALSE;
}

std::string DeviceFeatures::missing(const DeviceFeatures& required) const {
  std::string names;
  const auto compare = [&](VkBool32 wanted, VkBool32 offered, const char* name) {
    if (wanted && !offered) names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  };
  compare(required.features.features.fragmentStoresAndAtomics, features.features.fragmentStoresAndAtomics,
          "fragmentStoresAndAtomics");
  compare(required.vulkan12.bufferDeviceAddress, vulkan12.bufferDeviceAddress, "bufferDeviceAddress");
  compare(required.vulkan12.scalarBlockLayout, vulkan12.scalarBlockLayout, "scalarBlockLayout");
  compare(required.vulkan13.dynamicRendering, vulkan13.dynamicRendering, "dynamicRendering");
  compare(required.vulkan13.synchronization2, vulkan13.synchronization2, "synchronization2");
  compare(required.vulkan13.maintenance4, vulkan13.maintenance4, "maintenance4");
  compare(required.vulkan13.subgroupSizeControl, vulkan13.subgroupSizeControl, "subgroupSizeControl");
  return names;
}

DeviceInfo describe(VkPhysicalDevice device, std::uint32_t index) {
  VkPhysicalDeviceMaintenance4Properties maintenance4{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES};
  VkPhysicalDeviceVulkan11Properties vulkan11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES, &maintenance4};
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES, &vulkan11};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver};
  VkPhysicalDeviceProperties plain;
  vkGetPhysicalDeviceProperties(device, &plain);
  const bool isVulkan13 = plain.apiVersion >= VK_API_VERSION_1_3;
  if (isVulkan13)
    vkGetPhysicalDeviceProperties2(device, &properties);
  else
    properties.properties = plain;  // the structures above did not exist yet

  DeviceInfo info;
  info.index = index;
  info.name = plain.deviceName;
  info.type = typeName(plain.deviceType);
  info.driver = fmt::format("{} {}", driver.driverName, driver.driverInfo);
  info.apiVersion = fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(plain.apiVersion),
                                VK_API_VERSION_MINOR(plain.apiVersion), VK_API_VERSION_PATCH(plain.apiVersion));
  info.isCpu = plain.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  info.largestAllocationBytes = vulkan11.maxMemoryAllocationSize;
  info.largestStorageRangeBytes = plain.limits.maxStorageBufferRange;
  info.largestTexelBuffer = plain.limits.maxTexelBufferElements;
  info.largestImageSide =
      std::min({plain.limits.maxImageDimension2D, plain.limits.maxFramebufferWidth, plain.limits.maxFramebufferHeight});
  info.subgroupSize = vulkan11.subgroupSize;
  info.subpixels = 1u << plain.limits.subPixelPrecisionBits;
  info.subtexelBits = plain.limits.subTexelPrecisionBits;

  info.memory = memoryBudget(device);

  if (!isVulkan13) {
    info.missing = "Vulkan 1.3";
    return info;
  }
  DeviceFeatures required;
  required.require();
  DeviceFeatures offered;
  vkGetPhysicalDeviceFeatures2(device, &offered.features);
  info.hasFloat64 = offered.features.features.shaderFloat64 == VK_TRUE;
  info.missing = offered.missing(required);
  if (const std::string extensions = missingExtensions(device); !extensions.empty())
    info.missing += (info.missing.empty() ? "" : ", ") + extensions;
  if (!blendsFloat32(device))
    info.missing += fmt::format("{}blending of R32G32B32A32_SFLOAT", info.missing.empty() ? "" : ", ");
  return info;
}

std::vector<VkPhysicalDevice> physicalDevices(VkInstance instance) {
  std::uint32_t count = 0;
  VK_CHECK(vkEnumeratePhysicalDevices(instance, &count, nullptr));
  std::vector<VkPhysicalDevice> devices(count);
  VK_CHECK(vkEnumeratePhysicalDevices(instance, &count, devices.data()));
  return devices;
}

}  // namespace tetralux::gpu
