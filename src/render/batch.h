// Cells are projected and drawn in batches of up to BATCH_CELLS: what a batch needs on the device.
#pragma once

#include "gpu/buffer.h"
#include "shared/batch_arguments.h"
#include "shared/limits.h"

namespace tetralux::render {

struct BatchStorage {
  gpu::Buffer arguments;  // BatchArguments
  gpu::Buffer positions;  // vec2 ndc, FAN_VERTICES per cell
  gpu::Buffer ends;       // vec4, FAN_VERTICES per cell
  gpu::Buffer modes;      // uint per cell
  gpu::Buffer indices;    // FAN_INDICES per cell: the same fan pattern for every cell, written once
  gpu::TexelView endsView;
  gpu::TexelView modesView;

  BatchStorage(const gpu::Context& context, std::uint32_t cellCount);
  std::uint64_t sizeBytes() const;
};

}  // namespace tetralux::render
