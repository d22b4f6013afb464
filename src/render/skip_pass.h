// Pass "skip": which cells rays have to walk through with a transfer function, and the surface around them.
#pragma once

#include <cstdint>

#include "gpu/commands.h"
#include "render/gpu_mesh.h"
#include "render/pipeline_variants.h"
#include "render/walk_topology.h"
#include "shared/skip.h"

namespace tetralux::render {

// What the pass reads.
struct SkipInputs {
  const GpuMesh& mesh;
  const WalkTopology& whole;
  const gpu::TexelView& support;  // TransferBuffer::support(), or AppearanceBuffer's
  std::uint32_t supportCount = 0;
  bool showsEverywhere = false;  // the support covers the field: there is nothing to look for
  bool wideAddressing = false;
};

class SkipPass {
 public:
  // Throws Error(Device).
  SkipPass(const gpu::Context& context, std::uint32_t cellCount);

  // Marks the cells to keep: those that show and those between two of them. Counts them and the faces of the surface
  // around them; when that has run, counts() has the numbers.
  void recordMark(gpu::CommandBuffer& commands, const SkipInputs& inputs);
  const shared::SkipCounts& counts() const { return hostCounts_.as<shared::SkipCounts>()[0]; }

  // After recordMark(): writes the topology of the marked cells.
  //   kept   with room for as many faces as were counted
  void recordEnclose(gpu::CommandBuffer& commands, const SkipInputs& inputs, const WalkTopology& kept);

  std::uint64_t sizeBytes() const { return shows_.sizeBytes() + kept_.sizeBytes(); }

 private:
  void enclose(gpu::CommandBuffer& commands, const SkipInputs& inputs, const WalkTopology* kept);

  ComputeVariants mark_;
  ComputeVariants fill_;
  ComputeVariants enclose_;
  gpu::Buffer shows_;  // a bit per cell
  gpu::Buffer kept_;
  gpu::TexelView showsView_;
  gpu::TexelView keptView_;
  gpu::Buffer counts_;  // SkipCounts
  gpu::Buffer hostCounts_;
};

}  // namespace tetralux::render
