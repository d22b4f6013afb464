// Pass "project": sorted cells to fans of triangles, a batch at a time.
#pragma once

#include "render/batch.h"
#include "render/gpu_mesh.h"
#include "render/pipeline_variants.h"
#include "render/sort_pass.h"

namespace tetralux::render {

class ProjectPass {
 public:
  explicit ProjectPass(const gpu::Context& context);

  // Once per frame, after the sort: how large every batch is. Writes the arguments and counters.drawn.
  void recordArguments(gpu::CommandBuffer& commands, const gpu::Buffer& kept, const gpu::Buffer& counters,
                       const BatchStorage& batches);

  // Projects one batch. Writes positions, ends, modes; adds to counters.triangles and nearCells.
  void recordBatch(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
                   const gpu::Buffer& view, const gpu::Buffer& order, const gpu::TexelView& orderView,
                   const gpu::Buffer& counters, const BatchStorage& batches, std::uint32_t batch);

 private:
  ComputeVariants arguments_;
  ComputeVariants project_;
  gpu::Buffer truthTable_;
  gpu::TexelView truthTableView_;
};

}  // namespace tetralux::render
