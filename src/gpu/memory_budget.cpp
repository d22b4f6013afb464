#include "gpu/memory_budget.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/error.h"
#include "gpu/context.h"

namespace tetralux::gpu {
namespace {

bool hasBudget(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  VK_CHECK(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr));
  std::vector<VkExtensionProperties> available(count);
  VK_CHECK(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, available.data()));
  return std::any_of(available.begin(), available.end(), [](const VkExtensionProperties& e) {
    return std::strcmp(e.extensionName, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME) == 0;
  });
}

}  // namespace

MemoryBudget memoryBudget(VkPhysicalDevice device) {
  // A query about the device, not of it: the extension need not be enabled.
  VkPhysicalDeviceMemoryBudgetPropertiesEXT budget{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT};
  VkPhysicalDeviceMemoryProperties2 memory{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2, &budget};
  MemoryBudget result;
  result.isReported = hasBudget(device);
  if (result.isReported)
    vkGetPhysicalDeviceMemoryProperties2(device, &memory);
  else  // of any version of Vulkan
    vkGetPhysicalDeviceMemoryProperties(device, &memory.memoryProperties);
  for (std::uint32_t i = 0; i < memory.memoryProperties.memoryHeapCount; i++) {
    const VkMemoryHeap& heap = memory.memoryProperties.memoryHeaps[i];
    if ((heap.flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) == 0 || heap.size <= result.heapBytes) continue;
    result.heapBytes = heap.size;
    result.availableBytes =
        result.isReported ? budget.heapBudget[i] - std::min(budget.heapBudget[i], budget.heapUsage[i]) : heap.size;
  }
  return result;
}

void requireMemory(const Context& context, std::uint64_t neededBytes, const std::string& what) {
  const MemoryBudget budget = context.memoryBudget();
  if (!budget.isReported || neededBytes <= budget.availableBytes) return;
  fail(ErrorCode::Device, "out of memory: {} needs {} bytes, device '{}' has {} available", what, neededBytes,
       context.info().name, budget.availableBytes);
}

}  // namespace tetralux::gpu
