// Cells are projected and drawn in batches of BATCH_CELLS: what one batch and all of them need on the device.
#pragma once

#include "gpu/buffer.h"
#include "shared/batch_arguments.h"
#include "shared/limits.h"

namespace tetralux::render {

struct BatchStorage {
  std::uint32_t batchCount = 0;
  gpu::Buffer arguments;  // BatchArguments per batch
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
