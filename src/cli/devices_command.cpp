#include <fmt/format.h>

#include "cli/commands.h"
#include "gpu/context.h"

namespace tetralux::cli {
namespace {

std::string available(const gpu::MemoryBudget& memory) {
  if (!memory.isReported) return "unknown how much of it is available";
  return fmt::format("{} MiB available", memory.availableBytes >> 20);
}

class DevicesCommand : public Command {
 public:
  explicit DevicesCommand(CLI::App&) {}

  int run() override {
    const auto devices = gpu::listDevices();
    for (const gpu::DeviceInfo& d : devices) {
      fmt::print("{}: {}\n", d.index, d.name);
      fmt::print("   type               {}\n", d.type);
      fmt::print("   driver             {}\n", d.driver);
      fmt::print("   Vulkan             {}\n", d.apiVersion);
      fmt::print("   memory             {} MiB, {}\n", d.memory.heapBytes >> 20, available(d.memory));
      fmt::print("   largest buffer     {} MiB, {} MiB by descriptor, {} texels\n", d.largestAllocationBytes >> 20,
                 d.largestStorageRangeBytes >> 20, d.largestTexelBuffer);
      fmt::print("   largest image      {} pixels a side\n", d.largestImageSide);
      fmt::print("   subgroup           {}\n", d.subgroupSize);
      fmt::print("   usable             {}\n", d.missing.empty() ? "yes" : "no, lacks " + d.missing);
    }
    if (devices.empty()) fmt::print("no Vulkan device\n");
    return devices.empty() ? 4 : 0;
  }
};

}  // namespace

std::unique_ptr<Command> makeDevicesCommand(CLI::App& app) { return std::make_unique<DevicesCommand>(app); }

}  // namespace tetralux::cli
