// How much memory of the device this process may still take.
#pragma once

#include <cstdint>
#include <string>

#include "gpu/vulkan.h"

namespace tetralux::gpu {

class Context;

struct MemoryBudget {
  std::uint64_t heapBytes = 0;  // of the largest device-local heap
  // What can still be allocated there before others have to make room, by the driver's estimate; all of the heap where
  // the driver has none.
  std::uint64_t availableBytes = 0;
  bool isReported = false;  // the driver has an estimate (VK_EXT_memory_budget)
};

// As of now: other processes take and give back memory at any time.
MemoryBudget memoryBudget(VkPhysicalDevice device);

// Throws Error(Device) when this much more will not fit: nothing has been allocated then, and the message tells both
// numbers. What fits now may fail to be allocated nevertheless. Where the driver has no estimate, everything may fit.
//   what   that needs it, shown in the message
void requireMemory(const Context& context, std::uint64_t neededBytes, const std::string& what);

}  // namespace tetralux::gpu
