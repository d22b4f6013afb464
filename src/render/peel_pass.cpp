#include "render/peel_pass.h"

#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

using namespace gpu::access;

struct WaitPush {
  MeshAddresses mesh;
  TopologyAddresses topology;
  VkDeviceAddress keys;
  VkDeviceAddress waiting;
};

struct SeedPush {
  VkDeviceAddress waiting;
  VkDeviceAddress queue;
  std::uint32_t cellCount;
};

struct PeelPush {
  VkDeviceAddress neighbors;
  VkDeviceAddress waiting;
  VkDeviceAddress queue;
  VkDeviceAddress keys;
  VkDeviceAddress relationHeads;
};

}  // namespace

PeelStorage::PeelStorage(const gpu::Context& context, std::uint32_t cellCount, std::uint32_t relationRoom)
    : waiting(context, std::uint64_t{4} * cellCount, gpu::MemoryKind::Device, "peel waiting"),
      queue(context, std::uint64_t{4} * cellCount, gpu::MemoryKind::Device, "peel queue"),
      status(context, sizeof(shared::PeelStatus), gpu::MemoryKind::Device, "peel status"),
      relationHeads(context, relationRoom > 0 ? std::uint64_t{4} * cellCount : 4, gpu::MemoryKind::Device,
                    "relation heads"),
      waitingView(context, waiting, VK_FORMAT_R32_UINT) {
  growRelations(context, relationRoom);
}

void PeelStorage::growRelations(const gpu::Context& context, std::uint32_t capacity) {
  relations = {};
  relations =
      gpu::Buffer(context, std::uint64_t{capacity} * sizeof(shared::Relation), gpu::MemoryKind::Device, "relations");
  relationCapacity = capacity;
}

std::uint64_t PeelStorage::sizeBytes() const {
  return waiting.sizeBytes() + queue.sizeBytes() + status.sizeBytes() + relationHeads.sizeBytes() +
         relations.sizeBytes();
}

PeelPass::PeelPass(const gpu::Context& context)
    : wait_(context, "order/wait.comp"), seed_(context, "order/seed.comp"), peel_(context, "order/peel.comp") {}

void PeelPass::recordWait(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
                          const GpuTopology& topology, const gpu::Buffer& view, const gpu::Buffer& keys,
                          const gpu::TexelView& keyView, const PeelStorage& storage) {
  commands.fill(storage.status, 0);
  if (storage.relationCapacity > 0) {
    commands.fill(storage.relationHeads, shared::NO_NODE);
    commands.fill(storage.relations, shared::NO_NODE);
  }
  commands.barrier(kTransferWrite, kComputeReadWrite);
  const WaitPush push{mesh.addresses(), topology.addresses(), keys.address(), storage.waiting.address()};
  commands.dispatch(wait_.get(variant.specConstants()),
                    {view, mesh.cells(), mesh.vertices(), mesh.cellScalars(), topology.neighbors(), topology.sides(),
                     keyView, storage.waiting, storage.status},
                    push, mesh.cellCount());
}

void PeelPass::recordSeed(gpu::CommandBuffer& commands, bool wideAddressing, std::uint32_t cellCount,
                          const PeelStorage& storage) {
  const SeedPush push{storage.waiting.address(), storage.queue.address(), cellCount};
  commands.dispatch(seed_.get({{SPEC_WIDE_ADDRESSING, wideAddressing}}),
                    {storage.waitingView, storage.queue, storage.status}, push, cellCount);
}

void PeelPass::recordPeel(gpu::CommandBuffer& commands, bool wideAddressing, const GpuTopology& topology,
                          const gpu::Buffer& keys, const PeelStorage& storage) {
  const PeelPush push{topology.addresses().neighbors, storage.waiting.address(), storage.queue.address(),
                      keys.address(), storage.relationHeads.address()};
  commands.dispatch(peel_.get({{SPEC_WIDE_ADDRESSING, wideAddressing}, {SPEC_RELATIONS, storage.relationCapacity > 0}}),
                    {topology.neighbors(), storage.waiting, storage.queue, keys, storage.status, storage.relationHeads,
                     storage.relations},
                    push, 1);
}

}  // namespace tetralux::render
