#include "render/integration/incremental_table.h"

#include <glm/vec4.hpp>

#include "base/error.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

using namespace gpu::access;

struct StepPush {
  shared::TableParameters table;
  std::uint32_t slice;
};

std::uint64_t entriesPerSlice(const shared::TableParameters& p) { return std::uint64_t{p.width} * p.height; }

// Bytes of the whole table as four 32-bit floats per entry.
std::uint64_t entryBytes(const gpu::Context& context, const shared::TableParameters& p) {
  const std::uint64_t entries = entriesPerSlice(p) * p.depth;
  const std::uint64_t most =
      std::min<std::uint64_t>(context.info().largestTexelBuffer, context.info().largestStorageRangeBytes / 16);
  if (entries > most)
    fail(ErrorCode::Device, "--table-build incremental: {} entries, at most {} on this device", entries, most);
  return entries * sizeof(glm::vec4);
}

}  // namespace

IncrementalTable::IncrementalTable(const gpu::Context& context, const shared::TableParameters& parameters,
                                   const gpu::SpecConstants& constants)
    : parameters_(parameters),
      constants_(constants),
      entries_(context, entryBytes(context, parameters), gpu::MemoryKind::Device, "table entries"),
      entryView_(context, entries_, VK_FORMAT_R32G32B32A32_SFLOAT),
      start_(context, "tables/preintegrate.comp"),
      step_(context, "tables/preintegrate_step.comp"),
      pack_(context, "tables/pack.comp") {}

void IncrementalTable::record(gpu::CommandBuffer& commands, const TransferBuffer& transfer, const gpu::Buffer& words) {
  const std::uint64_t slice = entriesPerSlice(parameters_);
  shared::TableParameters unscaled = parameters_;
  unscaled.lightPerValue = 1.0f;
  unscaled.opacityPerValue = 1.0f;
  gpu::SpecConstants asFloats = constants_;
  for (gpu::SpecConstant& constant : asFloats) {
    if (constant.id == SPEC_TABLE_FORMAT) constant.value = shared::TABLE_F32;
  }
  commands.dispatch(start_.get(asFloats), {entries_, transfer.pieces(), transfer.pieceBins()}, unscaled, 2 * slice);
  for (std::uint32_t k = 2; k < parameters_.depth; k++) {
    commands.barrier(kComputeWrite, kComputeReadWrite);
    commands.dispatch(step_.get(constants_), {entries_, entryView_}, StepPush{parameters_, k}, slice);
  }
  commands.barrier(kComputeWrite, kComputeRead);
  commands.dispatch(pack_.get(constants_), {words, entryView_}, parameters_, slice * parameters_.depth);
}

}  // namespace tetralux::render
