#include "render/march_pass.h"

#include "render/shader_library.h"
#include "shared/march.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

using namespace gpu::access;

struct EnterPush {
  MeshAddresses mesh;
  VkDeviceAddress boundaryVertices;
  VkDeviceAddress boundaryCells;
  shared::PixelBand band;
};

struct WalkPush {
  MeshAddresses mesh;
  VkDeviceAddress neighbors;
  shared::PixelBand band;
};

// Invocations: one for every pixel of the tiles that hold a band.
std::uint64_t tileThreads(const shared::PixelBand& band) {
  const auto tiles = [](std::uint32_t pixels) {
    return std::uint64_t{pixels + shared::MARCH_TILE - 1} / shared::MARCH_TILE;
  };
  return tiles(band.width) * tiles(band.rowCount) * shared::MARCH_TILE * shared::MARCH_TILE;
}

}  // namespace

MarchPass::MarchPass(const gpu::Context& context)
    : context_(context),
      entriesVertex_(loadShader(context, "march/entries.vert")),
      entriesFragment_(loadShader(context, "march/entries.frag")),
      showVertex_(loadShader(context, "apart/blend.vert")),
      showFragment_(loadShader(context, "march/show.frag")),
      arrange_(context, "march/arrange.comp"),
      seek_(context, "march/seek.comp"),
      march_(context, "march/march.comp") {}

void MarchPass::recordEnter(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
                            const MarchStorage& storage, const shared::PixelBand& band) {
  const GpuTopology& topology = storage.topology();
  const PixelLists& lists = storage.lists();
  const EnterPush push{mesh.addresses(), topology.boundaryVertexAddress(), topology.boundaryCellAddress(), band};
  commands.beginRendering(band.width, lists.size().height, {band.firstRow, band.rowCount});
  commands.draw(
      enterPipeline(variant),
      {storage.view(), mesh.cells(), mesh.vertices(), mesh.cellScalars(), topology.boundaryVertices(),
       topology.neighbors(), topology.boundaryCells(), lists.heads(), lists.links(), lists.ranks(), lists.counts()},
      push, shared::MARCH_FACE_VERTICES * topology.boundaryCount());
  commands.endRendering();
  commands.barrier(kVertexRead | kFragmentReadWrite, kComputeReadWrite);
  commands.dispatch(arrange_.get({{SPEC_NEAR_CELLS, variant.nearCells}}),
                    {lists.heads(), lists.links(), lists.ranks(), storage.colors()}, band, tileThreads(band));
  commands.barrier(kComputeWrite, kComputeReadWrite);
}

void MarchPass::recordSeek(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
                           const MarchStorage& storage, const shared::PixelBand& band) {
  const PixelLists& lists = storage.lists();
  const WalkPush push{mesh.addresses(), storage.topology().addresses().neighbors, band};
  commands.dispatch(seek_.get(variant.specConstants()),
                    {storage.view(), mesh.cells(), mesh.vertices(), mesh.cellScalars(), storage.topology().neighbors(),
                     lists.heads(), lists.links(), lists.ranks(), storage.unfinished()},
                    push, tileThreads(band));
  commands.barrier(kComputeWrite, kComputeReadWrite);
}

void MarchPass::recordMarch(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
                            const TransferBuffer& transfer, const IntegrationTables& tables,
                            const MarchStorage& storage, const shared::PixelBand& band) {
  const PixelLists& lists = storage.lists();
  const WalkPush push{mesh.addresses(), storage.topology().addresses().neighbors, band};
  gpu::SpecConstants constants = variant.specConstants();
  constants.push_back({SPEC_EMISSION_PER_LENGTH, variant.emissionPerLength});
  for (const gpu::SpecConstant& constant : variant.integration.specConstants()) constants.push_back(constant);
  commands.dispatch(march_.get(constants),
                    {storage.view(), mesh.cells(), mesh.vertices(), mesh.cellScalars(), storage.topology().neighbors(),
                     transfer.pieces(), transfer.pieceBins(), lists.heads(), lists.links(), lists.ranks(),
                     storage.colors(), storage.unfinished(), tables.numbers(), tables.table2d(), tables.table3d()},
                    push, tileThreads(band));
  commands.barrier(kComputeWrite, kComputeReadWrite | kVertexRead);
}

void MarchPass::recordShow(gpu::CommandBuffer& commands, const MarchStorage& storage, const shared::PixelBand& band,
                           const gpu::AttachmentImage& target, bool clear) {
  commands.beginRendering(target, clear, {band.firstRow, band.rowCount});
  commands.draw(showPipeline(target.format()), {storage.colorsView()}, band, 3);
  commands.endRendering();
}

const gpu::GraphicsPipeline& MarchPass::enterPipeline(const FrameVariant& variant) {
  const std::tuple key{variant.wideAddressing, variant.perspective, variant.nearCells};
  const auto found = enter_.find(key);
  if (found != enter_.end()) return found->second;
  return enter_
      .emplace(key, gpu::GraphicsPipeline(context_, entriesVertex_, entriesFragment_, {}, variant.specConstants()))
      .first->second;
}

const gpu::GraphicsPipeline& MarchPass::showPipeline(VkFormat format) {
  const auto found = show_.find(format);
  if (found != show_.end()) return found->second;
  gpu::GraphicsState state;
  state.colorFormat = format;
  state.blendOver = false;
  return show_.emplace(format, gpu::GraphicsPipeline(context_, showVertex_, showFragment_, state)).first->second;
}

}  // namespace tetralux::render
