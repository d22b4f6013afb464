// Pass "order": the exact visibility order, by peeling cells from the back.
#pragma once

#include "gpu/commands.h"
#include "render/gpu_mesh.h"
#include "render/gpu_topology.h"
#include "render/pipeline_variants.h"
#include "shared/visibility.h"

namespace tetralux::render {

// Device memory of the order: 8 bytes per cell; with relations across gaps 4 more and 8 per pair of cells.
struct PeelStorage {
  gpu::Buffer waiting;        // state per cell (shared/visibility.h)
  gpu::Buffer queue;          // cells in the order they are peeled
  gpu::Buffer status;         // PeelStatus
  gpu::Buffer relationHeads;  // first relation of each cell; with relations only
  gpu::Buffer relations;      // Relation
  std::uint32_t relationCapacity = 0;
  gpu::TexelView waitingView;

  //   relationRoom   pairs across gaps that there is room for; 0: there are no gaps
  PeelStorage(const gpu::Context& context, std::uint32_t cellCount, std::uint32_t relationRoom);
  // Makes room for more pairs.
  void growRelations(const gpu::Context& context, std::uint32_t capacity);
  std::uint64_t sizeBytes() const;
};

class PeelPass {
 public:
  explicit PeelPass(const gpu::Context& context);

  // Clears the status and finds out for whom each cell has to wait. Relations between cells that share no face may be
  // added to the waiting counts afterwards.
  //   keys   from the cull pass
  void recordWait(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
                  const GpuTopology& topology, const gpu::Buffer& view, const gpu::Buffer& keys,
                  const gpu::TexelView& keyView, const PeelStorage& storage);

  // Starts the queue with the cells that wait for none.
  void recordSeed(gpu::CommandBuffer& commands, bool wideAddressing, std::uint32_t cellCount,
                  const PeelStorage& storage);

  // Peels up to 60000 levels. A peeled cell's key becomes its level.
  void recordPeel(gpu::CommandBuffer& commands, bool wideAddressing, const GpuTopology& topology,
                  const gpu::Buffer& keys, const PeelStorage& storage);

 private:
  ComputeVariants wait_;
  ComputeVariants seed_;
  ComputeVariants peel_;
};

}  // namespace tetralux::render
