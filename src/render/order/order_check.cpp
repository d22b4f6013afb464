#include "render/order/order_check.h"

namespace tetralux::render {
namespace {

using namespace gpu::access;

struct CheckPush {
  MeshAddresses mesh;
  TopologyAddresses topology;
  VkDeviceAddress keys;
  std::uint32_t keyShift;
  std::uint32_t tiesAreApart;
};

}  // namespace

OrderCheck::OrderCheck(const gpu::Context& context, const GpuTopology& topology, Relations& relations)
    : context_(context),
      topology_(topology),
      relations_(relations),
      check_(context, "order/check.comp"),
      count_(context, sizeof(shared::OrderCount), gpu::MemoryKind::Device, "order count") {}

void OrderCheck::recordFaces(const OrderInputs& inputs, SortRange range, bool tiesAreApart) {
  gpu::CommandBuffer& commands = inputs.recorder.pass("check");
  commands.fill(count_, 0);
  commands.barrier(kTransferWrite, kComputeReadWrite);
  const GpuMesh& mesh = inputs.mesh;
  const CheckPush push{mesh.addresses(), topology_.addresses(), inputs.sort.keys().address(), range.firstBit,
                       tiesAreApart};
  commands.dispatch(check_.get(inputs.variant.specConstants()),
                    {inputs.view, mesh.cells(), mesh.vertices(), mesh.cellScalars(), topology_.neighbors(),
                     topology_.sides(), inputs.sort.keyView(), count_},
                    push, mesh.cellCount());
  commands.barrier(kComputeWrite, kComputeReadWrite);
}

shared::OrderCount OrderCheck::counted() const {
  return gpu::downloadVector<shared::OrderCount>(context_, count_, 1)[0];
}

void OrderCheck::run(const OrderInputs& inputs, SortRange range, const CheckOptions& options, OrderReport& report) {
  const bool hasGaps = !topology_.isConvex();
  recordFaces(inputs, range, options.tiesAreApart);
  bool isWrong = false;
  if (hasGaps && options.onlyWhetherExact) {
    inputs.recorder.sync();
    isWrong = counted().misordered > 0;
  }
  if (hasGaps && !isWrong) {
    relations_.recordCheck(inputs, topology_, range, options.tiesAreApart, count_);
    inputs.recorder.sync();
    while (relations_.grow()) {
      recordFaces(inputs, range, options.tiesAreApart);
      relations_.recordCheck(inputs, topology_, range, options.tiesAreApart, count_);
      inputs.recorder.sync();
    }
  }
  inputs.recorder.sync();
  const shared::OrderCount count = counted();
  report.isChecked = true;
  report.faces = count.faces;
  report.misordered = count.misordered;
  report.relations = count.relations;
  report.misorderedRelations = count.misorderedRelations;
}

}  // namespace tetralux::render
