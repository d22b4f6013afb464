// Pass "project": sorted cells to fans of triangles, a batch at a time.
#pragma once

#include "render/batch.h"
#include "render/gpu_mesh.h"
#include "render/gpu_truth_table.h"
#include "render/order/cell_order.h"
#include "render/pipeline_variants.h"
#include "render/transfer_buffer.h"

namespace tetralux::render {

class ProjectPass {
 public:
  explicit ProjectPass(const gpu::Context& context);

  // Writes the arguments of a batch's draw and counters.drawn: all that cells need which the vertex shader projects.
  //   sequence  cells in drawing order
  //   slots     first, and behind the last; at most BATCH_CELLS, may go beyond those kept
  void recordArguments(gpu::CommandBuffer& commands, const FrameVariant& variant, const CellSequence& sequence,
                       SlotSpan slots, const gpu::Buffer& counters, const BatchStorage& batches);

  // Projects the cells of some slots: writes arguments, positions, ends and modes; adds to counters.triangles and
  // clipped unless they were projected before in this frame.
  void recordBatch(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
                   const TransferBuffer& transfer, const GpuTruthTable& truthTable, const gpu::Buffer& view,
                   const CellSequence& sequence, SlotSpan slots, const gpu::Buffer& counters,
                   const BatchStorage& batches, bool isCounted);

 private:
  ComputeVariants arguments_;
  ComputeVariants project_;
};

}  // namespace tetralux::render
