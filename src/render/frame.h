// One frame, from the mesh on the device to the picture on the device.
#pragma once

#include <memory>

#include "gpu/recorder.h"
#include "render/batch.h"
#include "render/cull_pass.h"
#include "render/frame_view.h"
#include "render/gpu_mesh.h"
#include "render/project_pass.h"
#include "render/raster_pass.h"
#include "render/sort_pass.h"
#include "render/transfer_buffer.h"
#include "shared/counters.h"

namespace tetralux::render {

// What only depends on the mesh: reused from frame to frame.
struct FrameStorage {
  SortStorage sort;
  BatchStorage batches;
  gpu::Buffer view;      // FrameView
  gpu::Buffer counters;  // FrameCounters

  FrameStorage(const gpu::Context& context, std::uint32_t cellCount, SortVariant sortVariant);
  std::uint64_t sizeBytes() const;
};

// The passes, in no order.
struct FramePasses {
  CullPass cull;
  SortPass sort;
  ProjectPass project;
  RasterPass raster;

  FramePasses(const gpu::Context& context, SortVariant sortVariant);
};

// Everything that one frame reads.
struct FrameInputs {
  const GpuMesh& mesh;
  const TransferBuffer& transfer;
  const FrameSetup& setup;
  FrameVariant variant;
};

// Records a frame into `target`, whose old content is forgotten.
void recordFrame(gpu::Recorder& recorder, const FrameInputs& inputs, FramePasses& passes, FrameStorage& storage,
                 const gpu::AttachmentImage& target);

}  // namespace tetralux::render
