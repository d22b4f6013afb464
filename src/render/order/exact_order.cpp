#include "render/order/exact_order.h"

#include <algorithm>
#include <bit>

#include "render/order/key_order.h"

namespace tetralux::render {

using namespace gpu::access;

ExactOrder::ExactOrder(const gpu::Context& context, VisibilityKit& kit, SortVariant variant)
    : context_(context), kit_(kit), peel_(context), sort_(context, variant) {}

void ExactOrder::recordStart(const OrderInputs& inputs) {
  {
    gpu::CommandBuffer& commands = inputs.recorder.pass("order");
    peel_.recordWait(commands, inputs.variant, inputs.mesh, kit_.topology, inputs.view, inputs.sort.keys(),
                     inputs.sort.keyView(), *storage_);
    commands.barrier(kComputeWrite, kComputeReadWrite);
  }
  if (!kit_.topology.isConvex()) kit_.relations.recordAdd(inputs, kit_.topology, *storage_);
  if (kit_.topology.overlapCount() > 0) kit_.relations.recordOverlaps(inputs, kit_.topology, *storage_);
  gpu::CommandBuffer& commands = inputs.recorder.pass("order");
  peel_.recordSeed(commands, inputs.variant.wideAddressing, inputs.mesh.cellCount(), *storage_);
  commands.barrier(kComputeWrite, kComputeReadWrite);
}

void ExactOrder::recordPeel(const OrderInputs& inputs) {
  gpu::CommandBuffer& commands = inputs.recorder.pass("order");
  peel_.recordPeel(commands, inputs.variant.wideAddressing, kit_.topology, inputs.sort.keys(), *storage_);
  commands.barrier(kComputeWrite, kComputeReadWrite);
}

shared::PeelStatus ExactOrder::peelAll(const OrderInputs& inputs) {
  recordStart(inputs);
  for (;;) {
    recordPeel(inputs);
    inputs.recorder.sync();
    const auto status = gpu::downloadVector<shared::PeelStatus>(context_, storage_->status, 1)[0];
    bool again = !kit_.topology.isConvex() && kit_.relations.grow();
    if (status.relations > storage_->relationCapacity) {
      storage_->growRelations(context_, status.relations + status.relations / 4);
      again = true;
    }
    if (again)
      recordStart(inputs);  // peeling changes no key's KEY_TRANSPARENT or KEY_OUTSIDE, which is all that is read
    else if (status.begin == status.end)
      return status;
  }
}

CycleReport ExactOrder::resolve(const OrderInputs& inputs, std::uint32_t levelCount) {
  const std::uint32_t cellCount = inputs.mesh.cellCount();
  const auto waiting = gpu::downloadVector<std::uint32_t>(context_, storage_->waiting, cellCount);
  const auto neighbors =
      gpu::downloadVector<std::array<std::uint32_t, 4>>(context_, kit_.topology.neighborBuffer(), cellCount);
  std::vector<std::uint32_t> relationHeads;
  std::vector<shared::Relation> relations;
  if (storage_->relationCapacity > 0) {
    relationHeads = gpu::downloadVector<std::uint32_t>(context_, storage_->relationHeads, cellCount);
    relations = gpu::downloadVector<shared::Relation>(context_, storage_->relations, storage_->relationCapacity);
  }
  auto keys = gpu::downloadVector<std::uint32_t>(context_, inputs.sort.keys(), cellCount);
  const CycleReport report = resolveCycles({waiting, neighbors, relationHeads, relations, levelCount}, keys);
  gpu::upload(context_, inputs.sort.keys(), keys.data(), keys.size() * sizeof(std::uint32_t));
  return report;
}

CellSequence ExactOrder::record(const OrderInputs& inputs) {
  if (!storage_) {
    // Room to start with: few boundary faces have more than one other behind them.
    const GpuTopology& topology = kit_.topology;
    const std::uint32_t relations =
        2 * ((topology.isConvex() ? 0 : topology.boundaryCount()) + topology.overlapCount());
    storage_ = std::make_unique<PeelStorage>(context_, inputs.mesh.cellCount(), relations);
  }
  const shared::PeelStatus status = peelAll(inputs);
  CycleReport cycles;
  cycles.largestKey = status.level;
  if (status.end < status.present) cycles = resolve(inputs, status.level);

  const SortRange range{0, std::max(1u, static_cast<std::uint32_t>(std::bit_width(cycles.largestKey)))};
  CellSequence sequence = sortedSequence(inputs.sort, range);
  sequence.apart = cycles.apart;
  sequence.report.order = Order::Exact;
  sequence.report.levels = status.level;
  sequence.report.cyclicCells = cycles.cyclicCells;
  sequence.report.apartCells = cycles.apartCells;
  if (inputs.check) kit_.check.run(inputs, range, {.tiesAreApart = true}, sequence.report);
  gpu::CommandBuffer& commands = inputs.recorder.pass("sort");
  sort_.record(commands, inputs.sort, range, inputs.variant.wideAddressing);
  commands.barrier(kComputeWrite, kComputeReadWrite);
  return sequence;
}

}  // namespace tetralux::render
