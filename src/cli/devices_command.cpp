#include <fmt/format.h>

#include "cli/commands.h"
#include "gpu/context.h"

namespace tetralux::cli {
namespace {

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
      fmt::print("   memory             {} MiB\n", d.memoryBytes >> 20);
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
