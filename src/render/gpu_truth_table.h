// The truth table on the device, for the passes that project cells.
#pragma once

#include <vector>

#include "gpu/buffer.h"
#include "render/truth_table.h"

namespace tetralux::render {

struct GpuTruthTable {
  gpu::Buffer buffer;  // uint per entry
  gpu::TexelView view;

  explicit GpuTruthTable(const gpu::Context& context) {
    const auto table = makeTruthTable();
    buffer = gpu::makeBuffer(context, std::vector<std::uint32_t>(table.begin(), table.end()), "truth table");
    view = gpu::TexelView(context, buffer, VK_FORMAT_R32_UINT);
  }
};

}  // namespace tetralux::render
