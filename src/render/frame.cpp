#include "render/frame.h"

#include <algorithm>

#include "shared/march.h"

namespace tetralux::render {
namespace {

using namespace gpu::access;

// A frame being recorded.
struct Frame {
  gpu::Recorder& recorder;
  const FrameInputs& inputs;
  FramePasses& passes;
  FrameStorage& storage;
  const FrameTarget& target;
  bool isCleared = false;  // the picture holds what was drawn so far
};

// The first pass that draws into the picture finds it empty.
bool takeClear(Frame& frame, gpu::CommandBuffer& commands) {
  if (frame.isCleared) return false;
  commands.prepareAttachment(frame.target.picture);
  frame.isCleared = true;
  return true;
}

template <typename Draw>
void forEachBatch(SlotSpan slots, std::uint32_t cells, const Draw& draw) {
  for (std::uint32_t first = slots.first; first < slots.end;) {
    const std::uint32_t end = first + std::min(cells, slots.end - first);
    draw(SlotSpan{first, end});
    first = end;
  }
}

void recordProject(Frame& frame, const CellSequence& sequence, SlotSpan batch, bool isCounted) {
  ProjectPass& project = frame.passes.project;
  const FrameInputs& inputs = frame.inputs;
  if (inputs.variant.gator) {
    // project: nothing but the number of cells; the vertex shader does it
    project.recordArguments(frame.recorder.pass("raster"), inputs.variant, sequence, batch, frame.storage.counters,
                            frame.storage.batches);
    return;
  }
  project.recordBatch(frame.recorder.pass("project"), inputs.variant, inputs.mesh, inputs.transfer,
                      frame.passes.truthTable, frame.storage.view, sequence, batch, frame.storage.counters,
                      frame.storage.batches, isCounted);
}

// What is drawn of a batch.
CellBatch cellBatch(const Frame& frame, const CellSequence& sequence, SlotSpan batch,
                    const shared::PixelBand& band = {}) {
  const FrameInputs& inputs = frame.inputs;
  return {inputs.mesh,
          inputs.transfer,
          inputs.tables,
          frame.storage.view,
          frame.passes.truthTable,
          sequence,
          frame.storage.batches,
          {inputs.setup.screen, band, batch.first},
          inputs.appearance};
}

// combine: a chunk over what lies behind
void combineChunk(Frame& frame, const gpu::AttachmentImage& chunk) {
  gpu::CommandBuffer& commands = frame.recorder.pass("combine");
  commands.prepareSampling(chunk);
  const bool clear = takeClear(frame, commands);
  frame.passes.combine.record(commands, chunk, frame.target.picture, clear);
  commands.barrier(kColorWrite, kColorWrite);
}

// project, raster: cells one after the other, each over what lies behind
void drawInOrder(Frame& frame, const CellSequence& sequence, SlotSpan slots) {
  const gpu::AttachmentImage* chunk = frame.target.chunk;
  forEachBatch(slots, chunk ? frame.target.chunkCells : shared::BATCH_CELLS, [&](SlotSpan batch) {
    recordProject(frame, sequence, batch, /*isCounted=*/true);
    gpu::CommandBuffer& commands = frame.recorder.pass("raster");
    if (chunk) commands.prepareAttachment(*chunk);
    const bool clear = chunk || takeClear(frame, commands);
    frame.passes.raster.recordBatch(commands, frame.inputs.variant, cellBatch(frame, sequence, batch),
                                    chunk ? *chunk : frame.target.picture, clear);
    commands.barrier(kVertexRead | kColorWrite, kComputeWrite | kColorWrite);  // the next batch reuses the fans
    if (chunk) combineChunk(frame, *chunk);
  });
}

// project, apart: cells into lists per pixel, a band of rows at a time, then the lists over what lies behind
void drawApart(Frame& frame, const CellSequence& sequence, SlotSpan slots) {
  const ImageSize size = frame.inputs.size;
  std::unique_ptr<PixelLists>& lists = frame.storage.lists;
  if (!lists || lists->size().width != size.width || lists->size().height != size.height) {
    lists.reset();
    lists = std::make_unique<PixelLists>(frame.inputs.context, size, /*withColors=*/true);
  }
  bool isCounted = true;
  for (std::uint32_t row = 0; row < size.height;) {
    const shared::PixelBand band = lists->bandFrom(row);
    {
      gpu::CommandBuffer& commands = frame.recorder.pass("apart");
      lists->recordClearCounts(commands);
      lists->recordClearLists(commands);
      commands.barrier(kTransferWrite, kFragmentReadWrite);
    }
    forEachBatch(slots, shared::BATCH_CELLS, [&](SlotSpan batch) {
      recordProject(frame, sequence, batch, isCounted);
      gpu::CommandBuffer& commands = frame.recorder.pass("apart");
      frame.passes.apart.recordStore(commands, frame.inputs.variant, cellBatch(frame, sequence, batch, band), *lists);
      commands.barrier(kVertexRead | kFragmentReadWrite, kComputeWrite | kFragmentReadWrite);
    });
    isCounted = false;
    frame.recorder.sync();
    if (lists->grow()) continue;
    gpu::CommandBuffer& commands = frame.recorder.pass("apart");
    frame.passes.apart.recordResolve(commands, *lists, band, sequence.kBuffer, frame.storage.shortPixels);
    commands.barrier(kComputeWrite, kFragmentReadWrite);
    const bool clear = takeClear(frame, commands);
    frame.passes.apart.recordBlend(commands, frame.inputs.variant, *lists, band, frame.target.picture, clear);
    commands.barrier(kFragmentReadWrite | kColorWrite, kTransferWrite | kFragmentReadWrite | kColorWrite);
    row += band.rowCount;
  }
}

// The view of a frame, for all that follows.
void recordView(gpu::CommandBuffer& commands, const FrameInputs& inputs, const gpu::Buffer& view) {
  commands.update(view, &inputs.setup.view, sizeof inputs.setup.view);
  if (inputs.appearance) inputs.appearance->recordCamera(commands, inputs.camera);
  commands.barrier(kTransferWrite, kAnyRead);
}

// Runs work that counts the rays it does not finish, again and again until there are none. Returns the counts.
template <typename Record>
shared::MarchCounts untilThrough(gpu::Recorder& recorder, const FrameInputs& inputs, const MarchStorage& storage,
                                 const Record& record) {
  // A ray meets a cell once, so this many times are enough; rounding may not make it go in circles for ever.
  const std::uint32_t most = 16 + 4 * (inputs.mesh.cellCount() / shared::MARCH_CELLS);
  const shared::MarchCounts& counts = storage.hostCounts().as<shared::MarchCounts>()[0];
  for (std::uint32_t i = 0; i < most; i++) {
    record();
    recorder.sync();
    if (counts.unfinished == 0) break;
  }
  return counts;
}

// enter: the faces through which each ray comes in
void recordEnter(gpu::Recorder& recorder, const FrameInputs& inputs, MarchPass& pass, const MarchStorage& storage,
                 const shared::PixelBand& band) {
  gpu::CommandBuffer& commands = recorder.pass("enter");
  if (band.firstRow == 0) recordView(commands, inputs, storage.view());
  pass.recordEnter(commands, inputs, storage, band);
}

// enter: the cells in which rays start
void findFirstCells(gpu::Recorder& recorder, const FrameInputs& inputs, MarchPass& pass, const MarchStorage& storage,
                    const shared::PixelBand& band) {
  untilThrough(recorder, inputs, storage, [&] {
    gpu::CommandBuffer& commands = recorder.pass("enter");
    storage.recordClearUnfinished(commands);
    pass.recordSeek(commands, inputs, storage, band);
    storage.recordReadCounts(commands, storage.hostCounts());
  });
}

// march: from there through the cells; the counts are then on the host
void recordWalk(gpu::CommandBuffer& commands, const FrameInputs& inputs, MarchPass& pass, const MarchStorage& storage,
                const shared::PixelBand& band, const gpu::Buffer& hostCounts) {
  storage.recordClearUnfinished(commands);
  pass.recordMarch(commands, inputs, storage, band);
  storage.recordReadCounts(commands, hostCounts);
}

// march: a band of the picture, from its colours
void recordShow(gpu::CommandBuffer& commands, MarchPass& pass, const MarchStorage& storage,
                const shared::PixelBand& band, const gpu::AttachmentImage& target) {
  const bool isFirst = band.firstRow == 0;
  if (isFirst) commands.prepareAttachment(target);
  pass.recordShow(commands, storage, band, target, /*clear=*/isFirst);
  commands.barrier(kVertexRead | kFragmentReadWrite | kColorWrite | kTransferRead | kTransferWrite,
                   kTransferWrite | kComputeReadWrite | kColorWrite);
}

void findRayEnds(gpu::Recorder& recorder, const FrameInputs& inputs, const MarchStorage& storage,
                 const shared::PixelBand& band) {
  do {
    inputs.surfaces->prepare(storage.bandPixels(), storage.bandTiles());
    inputs.surfacePass->record(recorder.pass("surfaces"), inputs.variant, *inputs.appearance, storage.view(),
                               *inputs.surfaces, band);
    recorder.sync();
  } while (inputs.surfaces->grow());
}

// Adds what a band had to do.
void addWork(MarchWork& work, const shared::MarchCounts& band, std::uint64_t faces) {
  const auto wide = [](std::uint32_t low, std::uint32_t high) { return std::uint64_t{high} << 32 | low; };
  work.faces += faces;
  work.jobs += band.jobs;
  work.entries += band.entries;
  work.cells += wide(band.cellsLow, band.cellsHigh);
  work.parts += wide(band.partsLow, band.partsHigh);
}

}  // namespace

FrameStorage::FrameStorage(const gpu::Context& context, std::uint32_t cellCount, SortVariant sortVariant,
                           CellProjection projection)
    : sort(context, cellCount, sortVariant),
      batches(context, cellCount, projection),
      view(context, sizeof(shared::FrameView), gpu::MemoryKind::Device, "frame view"),
      counters(context, sizeof(shared::FrameCounters), gpu::MemoryKind::Device, "frame counters"),
      shortPixels(context, sizeof(std::uint32_t), gpu::MemoryKind::Device, "short pixels") {}

std::uint64_t FrameStorage::sizeBytes() const {
  return sort.sizeBytes() + batches.sizeBytes() + view.sizeBytes() + counters.sizeBytes() + shortPixels.sizeBytes() +
         (lists ? lists->sizeBytes() : 0);
}

FramePasses::FramePasses(const gpu::Context& context)
    : truthTable(context), cull(context), project(context), raster(context), combine(context), apart(context) {}

OrderReport drawFrame(gpu::Recorder& recorder, const FrameInputs& inputs, FramePasses& passes, CellOrder& order,
                      FrameStorage& storage, const FrameTarget& target) {
  Frame frame{recorder, inputs, passes, storage, target};

  // cull: a sort key for every cell that a pixel's ray meets
  {
    gpu::CommandBuffer& commands = recorder.pass("cull");
    recordView(commands, inputs, storage.view);
    commands.fill(storage.counters, 0);
    commands.fill(storage.shortPixels, 0);
    commands.barrier(kTransferWrite, kComputeReadWrite);
    const gpu::TexelView& support = inputs.appearance ? inputs.appearance->support() : inputs.transfer.support();
    passes.cull.record(commands, inputs.variant, inputs.mesh, support, storage.view, storage.sort.keys(),
                       storage.counters);
    commands.barrier(kComputeWrite, kComputeReadWrite);
  }

  // order, check, sort: the cells that can be seen, those behind first
  CellSequence sequence = order.record({recorder, inputs.mesh, inputs.setup, inputs.variant, inputs.size, storage.view,
                                        storage.sort, inputs.checkOrder});

  // project, raster, apart: light through the cells, from the back
  std::uint32_t next = 0;
  for (const SlotSpan& apart : sequence.apart) {
    drawInOrder(frame, sequence, {next, apart.first});
    drawApart(frame, sequence, apart);
    next = apart.end;
  }
  drawInOrder(frame, sequence, {next, inputs.mesh.cellCount()});

  recorder.sync();
  if (sequence.kBuffer > 0)
    sequence.report.shortPixels = gpu::downloadVector<std::uint32_t>(inputs.context, storage.shortPixels, 1)[0];
  return sequence.report;
}

MarchWork marchFrame(gpu::Recorder& recorder, const FrameInputs& inputs, MarchPass& pass, MarchStorage& storage,
                     const gpu::AttachmentImage& target) {
  MarchWork work;
  storage.prepare(inputs.size, inputs.walkTopology(storage).boundaryCount());
  for (std::uint32_t row = 0; row < inputs.size.height;) {
    const shared::PixelBand band = storage.bandFrom(row);

    recordEnter(recorder, inputs, pass, storage, band);
    if (inputs.variant.nearCells) findFirstCells(recorder, inputs, pass, storage, band);

    // surfaces: the opaque triangles at which rays end
    if (inputs.surfaces) findRayEnds(recorder, inputs, storage, band);

    // The picture is nearly always complete after the first time, so it goes with the walk.
    const shared::MarchCounts counts = untilThrough(recorder, inputs, storage, [&] {
      gpu::CommandBuffer& commands = recorder.pass("march");
      recordWalk(commands, inputs, pass, storage, band, storage.hostCounts());
      if (!inputs.surfaces) recordShow(commands, pass, storage, band, target);
    });
    if (storage.grow(counts)) continue;
    addWork(work, counts, inputs.walkTopology(storage).boundaryCount());
    if (inputs.surfaces) {
      gpu::CommandBuffer& commands = recorder.pass("march");
      inputs.surfacePass->recordBehind(commands, *inputs.surfaces, storage.colors(), band);
      recordShow(commands, pass, storage, band, target);
    }
    row += band.rowCount;
  }
  recorder.sync();
  return work;
}

bool canRunAhead(const FrameInputs& inputs, MarchStorage& storage) {
  storage.prepare(inputs.size, inputs.walkTopology(storage).boundaryCount());
  return !inputs.variant.nearCells && !inputs.surfaces && storage.bandRows() >= inputs.size.height;
}

void recordMarchFrame(gpu::Recorder& recorder, const FrameInputs& inputs, MarchPass& pass, const MarchStorage& storage,
                      const gpu::AttachmentImage& target, const gpu::Buffer& hostCounts) {
  const shared::PixelBand band = storage.bandFrom(0);
  recordEnter(recorder, inputs, pass, storage, band);
  gpu::CommandBuffer& commands = recorder.pass("march");
  recordWalk(commands, inputs, pass, storage, band, hostCounts);
  recordShow(commands, pass, storage, band, target);
}

}  // namespace tetralux::render
