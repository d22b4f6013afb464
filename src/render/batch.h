// Cells are projected and drawn in batches of up to BATCH_CELLS: what a batch needs on the device.
#pragma once

#include "gpu/buffer.h"
#include "render/projection.h"
#include "shared/batch_arguments.h"
#include "shared/limits.h"

namespace tetralux::render {

struct BatchStorage {
  gpu::Buffer arguments;  // BatchArguments
  // What cells are projected to; none of them for CellProjection::Gator.
  gpu::Buffer positions;  // vec2 ndc, FAN_VERTICES per cell
  gpu::Buffer ends;       // vec4, FAN_VERTICES per cell
  gpu::Buffer modes;      // uint per cell
  gpu::Buffer indices;    // the same pattern of triangles for every cell, written once
  gpu::TexelView endsView;
  gpu::TexelView modesView;

  // The pattern is the ring (OUTLINE_INDICES) for CellProjection::Silhouette, otherwise the fan (FAN_INDICES).
  BatchStorage(const gpu::Context& context, std::uint32_t cellCount, CellProjection projection = CellProjection::Pt);
  std::uint64_t sizeBytes() const;
};

}  // namespace tetralux::render
