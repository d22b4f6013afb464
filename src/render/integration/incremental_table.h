// Pre-integrated tables slice by slice (Weiler et al. 2003; Kraus, Qiao and Ebert 2004, section 3).
#pragma once

#include "gpu/commands.h"
#include "render/pipeline_variants.h"
#include "render/transfer_buffer.h"
#include "shared/integration.h"

namespace tetralux::render {

// The first two slices are integrated exactly; every other is put together from looking up two parts of its segments in
// those before it. The error is that of interpolating between entries, once per slice.
class IncrementalTable {
 public:
  // Takes 16 bytes per entry until it is destroyed. Throws Error(Device) when that is more than the device can read.
  //   parameters   of a table with at least two slices
  //   constants    of the shaders: table format, integration, emission
  IncrementalTable(const gpu::Context& context, const shared::TableParameters& parameters,
                   const gpu::SpecConstants& constants);

  // Makes the table and writes it, packed, to `words`. Both must outlive the execution.
  void record(gpu::CommandBuffer& commands, const TransferBuffer& transfer, const gpu::Buffer& words);

 private:
  shared::TableParameters parameters_;
  gpu::SpecConstants constants_;
  gpu::Buffer entries_;
  gpu::TexelView entryView_;
  ComputeVariants start_;
  ComputeVariants step_;
  ComputeVariants pack_;
};

}  // namespace tetralux::render
