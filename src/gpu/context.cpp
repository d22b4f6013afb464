#include "gpu/context.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <optional>

#include "base/error.h"
#include "gpu/buffer.h"
#include "gpu/validation.h"

namespace tetralux::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

void loadVulkan() {
  if (volkInitialize() != VK_SUCCESS)
    fail(ErrorCode::Device, "no Vulkan loader (libvulkan.so.1) on this machine, expected Vulkan 1.3");
  if (volkGetInstanceVersion() < VK_API_VERSION_1_3)
    fail(ErrorCode::Device, "the Vulkan loader is version {}.{}, expected 1.3",
         VK_API_VERSION_MAJOR(volkGetInstanceVersion()), VK_API_VERSION_MINOR(volkGetInstanceVersion()));
}

bool hasValidationLayer() {
  std::uint32_t count = 0;
  VK_CHECK(vkEnumerateInstanceLayerProperties(&count, nullptr));
  std::vector<VkLayerProperties> layers(count);
  VK_CHECK(vkEnumerateInstanceLayerProperties(&count, layers.data()));
  return std::any_of(layers.begin(), layers.end(),
                     [](const VkLayerProperties& l) { return std::strcmp(l.layerName, kValidationLayer) == 0; });
}

VkInstance makeInstance(bool validation) {
  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = "tetralux";
  application.apiVersion = VK_API_VERSION_1_3;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;

  const std::array<const char*, 1> layers = {kValidationLayer};
  const std::array<const char*, 1> extensions = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME};
  const std::array<VkValidationFeatureEnableEXT, 1> enabled = {
      VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  VkDebugUtilsMessengerCreateInfoEXT messenger = validationMessenger();
  VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT, &messenger};
  features.enabledValidationFeatureCount = static_cast<std::uint32_t>(enabled.size());
  features.pEnabledValidationFeatures = enabled.data();
  if (validation) {
    if (!hasValidationLayer())
      fail(ErrorCode::Device, "validation was asked for, and {} is not installed", kValidationLayer);
    info.pNext = &features;
    info.enabledLayerCount = static_cast<std::uint32_t>(layers.size());
    info.ppEnabledLayerNames = layers.data();
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
  }
  VkInstance instance = VK_NULL_HANDLE;
  const VkResult result = vkCreateInstance(&info, nullptr, &instance);
  if (result != VK_SUCCESS)
    fail(ErrorCode::Device, "no Vulkan driver could be started: vkCreateInstance gave {}", resultName(result));
  volkLoadInstance(instance);
  return instance;
}

std::string lowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Higher is better.
int typeRank(const DeviceInfo& info) {
  if (info.type == "discrete GPU") return 4;
  if (info.type == "integrated GPU") return 3;
  if (info.type == "virtual GPU") return 2;
  return info.isCpu ? 1 : 0;
}

bool matches(const DeviceInfo& info, const std::string& wanted) {
  const bool isIndex =
      !wanted.empty() && std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c); });
  if (isIndex) return std::to_string(info.index) == wanted;
  return lowerCase(info.name).find(lowerCase(wanted)) != std::string::npos;
}

}  // namespace

Context::Context(const ContextOptions& options) : availableBytes_(options.availableBytes) {
  try {
    loadVulkan();
    createInstance(options.validation);
    chooseDevice(options.device);
    createDevice();
    smallReadback_ = std::make_unique<Buffer>(*this, kSmallBytes, MemoryKind::Readback, "small downloads");
  } catch (...) {
    destroy();
    throw;
  }
}

Context::~Context() { destroy(); }

void Context::destroy() {
  smallReadback_.reset();
  if (commandPool_) vkDestroyCommandPool(device_, commandPool_, nullptr);
  if (device_) vkDestroyDevice(device_, nullptr);
  if (messenger_) destroyMessenger_(instance_, messenger_, nullptr);
  if (instance_) vkDestroyInstance(instance_, nullptr);
}

void Context::createInstance(bool validation) {
  validation_ = validation;
  instance_ = makeInstance(validation);
  if (!validation) return;
  destroyMessenger_ = vkDestroyDebugUtilsMessengerEXT;
  setObjectName_ = vkSetDebugUtilsObjectNameEXT;
  const VkDebugUtilsMessengerCreateInfoEXT info = validationMessenger();
  VK_CHECK(vkCreateDebugUtilsMessengerEXT(instance_, &info, nullptr, &messenger_));
}

void Context::chooseDevice(const std::string& wanted) {
  const std::vector<VkPhysicalDevice> devices = physicalDevices(instance_);
  if (devices.empty()) fail(ErrorCode::Device, "Vulkan found no device, expected at least one (lavapipe will do)");
  std::vector<std::string> names;
  std::optional<DeviceInfo> unusable;
  int bestRank = -1;
  for (std::uint32_t i = 0; i < devices.size(); i++) {
    const DeviceInfo info = describe(devices[i], i);
    names.push_back(fmt::format("{}: {}", i, info.name));
    if (!matches(info, wanted)) continue;
    if (!info.missing.empty()) {
      unusable = info;
    } else if (typeRank(info) > bestRank) {
      bestRank = typeRank(info);
      physicalDevice_ = devices[i];
      info_ = info;
    }
  }
  if (physicalDevice_) return;
  if (unusable) fail(ErrorCode::Device, "device {} '{}' lacks {}", unusable->index, unusable->name, unusable->missing);
  fail(ErrorCode::Device, "no device matches '{}', expected one of {}", wanted, fmt::join(names, ", "));
}

void Context::createDevice() {
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physicalDevice_, &properties);
  timestampPeriodNs_ = properties.limits.timestampPeriod;

  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice_, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice_, &count, families.data());
  constexpr VkQueueFlags kNeeded = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  const auto family = std::find_if(families.begin(), families.end(), [](const VkQueueFamilyProperties& f) {
    return (f.queueFlags & kNeeded) == kNeeded;
  });
  if (family == families.end())
    fail(ErrorCode::Device, "device '{}' has no queue for both graphics and compute", info_.name);
  queueFamily_ = static_cast<std::uint32_t>(family - families.begin());

  const float priority = 1.0f;
  VkDeviceQueueCreateInfo queueInfo{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queueInfo.queueFamilyIndex = queueFamily_;
  queueInfo.queueCount = 1;
  queueInfo.pQueuePriorities = &priority;
  DeviceFeatures features;
  features.require();
  features.take(info_);
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features.features};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queueInfo;
  info.enabledExtensionCount = static_cast<std::uint32_t>(requiredExtensions().size());
  info.ppEnabledExtensionNames = requiredExtensions().data();
  VK_CHECK(vkCreateDevice(physicalDevice_, &info, nullptr, &device_));
  vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);

  VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  poolInfo.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  poolInfo.queueFamilyIndex = queueFamily_;
  VK_CHECK(vkCreateCommandPool(device_, &poolInfo, nullptr, &commandPool_));
}

std::uint32_t Context::memoryType(std::uint32_t allowedTypes, VkMemoryPropertyFlags required,
                                  VkMemoryPropertyFlags preferred) const {
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physicalDevice_, &memory);
  for (const VkMemoryPropertyFlags wanted : {required | preferred, required}) {
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; i++) {
      if ((allowedTypes >> i & 1) != 0 && (memory.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    }
  }
  fail(ErrorCode::Device, "device '{}' has no memory with properties {:#x}", info_.name, required);
}

MemoryBudget Context::memoryBudget() const {
  MemoryBudget budget = gpu::memoryBudget(physicalDevice_);
  if (availableBytes_) {
    budget.availableBytes = *availableBytes_;
    budget.isReported = true;
  }
  return budget;
}

void Context::setName(VkObjectType type, std::uint64_t handle, const std::string& name) const {
  if (!validation_) return;
  VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
  info.objectType = type;
  info.objectHandle = handle;
  info.pObjectName = name.c_str();
  VK_CHECK(setObjectName_(device_, &info));
}

std::vector<DeviceInfo> listDevices() {
  loadVulkan();
  const VkInstance instance = makeInstance(false);
  std::vector<DeviceInfo> result;
  const std::vector<VkPhysicalDevice> devices = physicalDevices(instance);
  for (std::uint32_t i = 0; i < devices.size(); i++) result.push_back(describe(devices[i], i));
  vkDestroyInstance(instance, nullptr);
  return result;
}

}  // namespace tetralux::gpu
