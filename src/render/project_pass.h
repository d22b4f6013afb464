// Pass "project": sorted cells to fans of triangles, a batch at a time.
#pragma once

#include "render/batch.h"
#include "render/gpu_mesh.h"
#include "render/order/cell_order.h"
#include "render/pipeline_variants.h"
#include "render/transfer_buffer.h"

namespace tetralux::render {

class ProjectPass {
 public:
  explicit ProjectPass(const gpu::Context& context);

  // Projects the cells of some slots, at most BATCH_CELLS. Writes the batch's arguments, positions, ends, modes and
  // counters.drawn; adds to counters.triangles and clipped unless they were projected before in this frame.
  //   slots     first, and behind the last; may go beyond those kept
  //   sequence  cells in drawing order
  void recordBatch(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
                   const TransferBuffer& transfer, const gpu::Buffer& view, const CellSequence& sequence,
                   SlotSpan slots, const gpu::Buffer& counters, const BatchStorage& batches, bool isCounted);

 private:
  ComputeVariants arguments_;
  ComputeVariants project_;
  gpu::Buffer truthTable_;
  gpu::TexelView truthTableView_;
};

}  // namespace tetralux::render
