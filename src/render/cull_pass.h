// Pass "cull": which cells can show, and their sort keys.
#pragma once

#include "gpu/commands.h"
#include "render/frame_view.h"
#include "render/gpu_mesh.h"
#include "render/pipeline_variants.h"
#include "render/transfer_buffer.h"

namespace tetralux::render {

class CullPass {
 public:
  explicit CullPass(const gpu::Context& context);

  // Records the pass. Counters must be zero; they and the keys are written.
  //   view       FrameView
  //   keys       one per cell: smaller for cells farther away, KEY_TRANSPARENT | key, or KEY_OUTSIDE
  //   counters   FrameCounters: outside, noSample, transparent
  void record(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
              const gpu::TexelView& support, const gpu::Buffer& view, const gpu::Buffer& keys,
              const gpu::Buffer& counters);

 private:
  ComputeVariants pipelines_;
};

}  // namespace tetralux::render
