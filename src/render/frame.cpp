#include "render/frame.h"

namespace tetralux::render {

using namespace gpu::access;

FrameStorage::FrameStorage(const gpu::Context& context, std::uint32_t cellCount, SortVariant sortVariant)
    : sort(context, cellCount, sortVariant),
      batches(context, cellCount),
      view(context, sizeof(shared::FrameView), gpu::MemoryKind::Device, "frame view"),
      counters(context, sizeof(shared::FrameCounters), gpu::MemoryKind::Device, "frame counters") {}

std::uint64_t FrameStorage::sizeBytes() const {
  return sort.sizeBytes() + batches.sizeBytes() + view.sizeBytes() + counters.sizeBytes();
}

FramePasses::FramePasses(const gpu::Context& context, SortVariant sortVariant)
    : cull(context), sort(context, sortVariant), project(context), raster(context) {}

void recordFrame(gpu::Recorder& recorder, const FrameInputs& inputs, FramePasses& passes, FrameStorage& storage,
                 const gpu::AttachmentImage& target) {
  const auto& [mesh, transfer, setup, variant] = inputs;
  const std::uint32_t keyBits = setup.view.keyBits;

  // cull: a sort key for every cell that can show
  {
    gpu::CommandBuffer& commands = recorder.pass("cull");
    commands.fill(storage.counters, 0);
    commands.barrier(kTransferWrite, kComputeReadWrite);
    passes.cull.record(commands, variant, mesh, transfer, storage.view, storage.sort.keys(), storage.counters);
    commands.barrier(kComputeWrite, kComputeReadWrite);
  }

  // sort: those cells, farthest first
  {
    gpu::CommandBuffer& commands = recorder.pass("sort");
    passes.sort.record(commands, storage.sort, keyBits, variant.wideAddressing);
    commands.barrier(kComputeWrite, kComputeReadWrite);
  }

  for (std::uint32_t batch = 0; batch < storage.batches.batchCount; batch++) {
    // project: the batch's cells to fans of triangles
    {
      gpu::CommandBuffer& commands = recorder.pass("project");
      if (batch == 0) {
        passes.project.recordArguments(commands, storage.sort.kept(), storage.counters, storage.batches);
        commands.barrier(kComputeWrite, kIndirectRead | kComputeReadWrite);
      }
      passes.project.recordBatch(commands, variant, mesh, storage.view, storage.sort.order(keyBits),
                                 storage.sort.orderView(keyBits), storage.counters, storage.batches, batch);
      commands.barrier(kComputeWrite, kVertexRead | kComputeReadWrite);
    }

    // raster: light through every cell of the batch, over what lies behind
    {
      gpu::CommandBuffer& commands = recorder.pass("raster");
      if (batch == 0) commands.prepareAttachment(target);
      passes.raster.recordBatch(commands, variant, setup.raster, transfer, storage.batches, batch, target);
      commands.barrier(kVertexRead | kColorWrite, kComputeWrite | kColorWrite);  // the next batch reuses the fans
    }
  }
}

}  // namespace tetralux::render
