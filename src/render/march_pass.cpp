#include "render/march_pass.h"

#include <cstddef>

#include "render/frame.h"
#include "render/shader_library.h"
#include "shared/march.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

using namespace gpu::access;

struct BinPush {
  MeshAddresses mesh;
  VkDeviceAddress boundary;
  shared::PixelBand band;
  std::uint32_t faceCount;
  std::uint32_t jobCapacity;
};

struct EnterPush {
  MeshAddresses mesh;
  VkDeviceAddress vertexRests;
  VkDeviceAddress boundary;
  shared::PixelBand band;
  std::uint32_t jobCapacity;
};

struct WalkPush {
  MeshAddresses mesh;
  VkDeviceAddress vertexRests;
  VkDeviceAddress across;
  shared::PixelBand band;
};

constexpr std::uint64_t kJobGroups = offsetof(shared::MarchCounts, jobGroups);
constexpr std::uint64_t kWalkTiles = offsetof(shared::MarchCounts, walkTiles);
constexpr std::uint64_t kSortTiles = offsetof(shared::MarchCounts, sortTiles);

}  // namespace

MarchPass::MarchPass(const gpu::Context& context)
    : context_(context),
      showVertex_(loadShader(context, "apart/blend.vert")),
      showFragment_(loadShader(context, "march/show.frag")),
      bin_(context, "march/bin.comp"),
      arrange_(context, "march/arrange.comp") {
  single_.emplace(context, "");
  if (context.info().hasFloat64) double_.emplace(context, "_precise");
}

MarchPass::Walk::Walk(const gpu::Context& context, const std::string& suffix)
    : enter(context, "march/enter" + suffix + ".comp"),
      seek(context, "march/seek" + suffix + ".comp"),
      march(context, "march/march" + suffix + ".comp"),
      marchMethods(context, "march/march_methods" + suffix + ".comp"),
      marchAppearance(context, "march/march_appearance" + suffix + ".comp") {}

MarchPass::Walk& MarchPass::walk(const FrameVariant& variant) { return variant.doublePrecision ? *double_ : *single_; }

void MarchPass::recordEnter(gpu::CommandBuffer& commands, const FrameInputs& inputs, const MarchStorage& storage,
                            const shared::PixelBand& band) {
  const FrameVariant& variant = inputs.variant;
  const GpuMesh& mesh = inputs.mesh;
  const WalkTopology& topology = inputs.walkTopology(storage);
  storage.recordClear(commands);
  commands.barrier(kTransferWrite, kComputeReadWrite | kIndirectRead);
  const BinPush binPush{mesh.addresses(), topology.boundaryAddress(), band, topology.boundaryCount(),
                        storage.room().jobs};
  const gpu::SpecConstant jobLanes{SPEC_JOB_LANES, variant.jobLanes};
  gpu::SpecConstants binConstants = variant.specConstants();
  binConstants.push_back(jobLanes);
  commands.dispatch(bin_.get(binConstants),
                    {storage.view(), mesh.cells(), mesh.vertices(), mesh.cellScalars(), topology.boundary(),
                     storage.jobs(), storage.tileMarks(), storage.walkTiles(), storage.counts()},
                    binPush, topology.boundaryCount());
  commands.barrier(kComputeWrite, kComputeReadWrite | kIndirectRead);
  gpu::SpecConstants enterConstants = variant.specConstants();
  enterConstants.push_back({SPEC_COUNT_WORK, variant.countWork});
  enterConstants.push_back(jobLanes);
  const EnterPush enterPush{mesh.addresses(), storage.vertexRestAddress(), topology.boundaryAddress(), band,
                            storage.room().jobs};
  commands.dispatchIndirect(
      walk(variant).enter.get(enterConstants),
      {storage.view(), mesh.cells(), mesh.vertices(), mesh.cellScalars(), topology.boundary(), topology.across(),
       storage.heads(), storage.links(), storage.ranks(), storage.jobsView(), storage.tileMarks(), storage.walkTiles(),
       storage.sortTiles(), storage.counts(), storage.vertexRests()},
      enterPush, storage.counts(), kJobGroups);
  commands.barrier(kComputeWrite, kComputeReadWrite | kIndirectRead);
  commands.dispatchIndirect(
      arrange_.get({{SPEC_NEAR_CELLS, variant.nearCells}, {SPEC_DISPATCH_THREADS, variant.dispatchThreads}}),
      {storage.heads(), storage.links(), storage.ranks(),
       variant.nearCells ? storage.walkTiles() : storage.sortTiles()},
      band, storage.counts(), variant.nearCells ? kWalkTiles : kSortTiles);
  commands.barrier(kComputeReadWrite, kComputeReadWrite | kTransferWrite);
}

void MarchPass::recordSeek(gpu::CommandBuffer& commands, const FrameInputs& inputs, const MarchStorage& storage,
                           const shared::PixelBand& band) {
  const FrameVariant& variant = inputs.variant;
  const GpuMesh& mesh = inputs.mesh;
  const WalkTopology& topology = inputs.walkTopology(storage);
  const WalkPush push{mesh.addresses(), storage.vertexRestAddress(), topology.acrossAddress(), band};
  commands.dispatchIndirect(
      walk(variant).seek.get(variant.specConstants()),
      {storage.view(), mesh.cells(), mesh.vertices(), mesh.cellScalars(), topology.across(), storage.heads(),
       storage.links(), storage.ranks(), storage.counts(), storage.walkTiles(), storage.vertexRests()},
      push, storage.counts(), kWalkTiles);
  commands.barrier(kComputeReadWrite, kComputeReadWrite | kTransferWrite);
}

void MarchPass::recordMarch(gpu::CommandBuffer& commands, const FrameInputs& inputs, const MarchStorage& storage,
                            const shared::PixelBand& band) {
  const FrameVariant& variant = inputs.variant;
  const GpuMesh& mesh = inputs.mesh;
  const TransferBuffer& transfer = inputs.transfer;
  const AppearanceBuffer* appearance = inputs.appearance;
  const WalkTopology& topology = inputs.walkTopology(storage);
  const WalkPush push{mesh.addresses(), storage.vertexRestAddress(), topology.acrossAddress(), band};
  gpu::SpecConstants constants = variant.specConstants();
  constants.push_back({SPEC_EMISSION_PER_LENGTH, variant.emissionPerLength});
  constants.push_back({SPEC_COUNT_WORK, variant.countWork});
  constants.push_back({SPEC_TURN_ROUNDS, variant.turnRounds});
  for (const gpu::SpecConstant& constant : variant.integration.specConstants()) constants.push_back(constant);
  gpu::Descriptors bindings{storage.view(),
                            mesh.cells(),
                            mesh.vertices(),
                            mesh.cellScalars(),
                            topology.across(),
                            transfer.pieces(),
                            transfer.pieceBins(),
                            storage.heads(),
                            storage.links(),
                            storage.ranks(),
                            storage.colors(),
                            storage.counts(),
                            appearance ? appearance->points() : transfer.points(),
                            appearance ? appearance->pointScalars() : transfer.pointScalars(),
                            storage.walkTiles(),
                            storage.vertexRests()};
  if (appearance) {
    for (const gpu::SpecConstant& constant : appearance->specConstants()) constants.push_back(constant);
    for (const gpu::TexelView* view : {&appearance->texels(), &appearance->gradients(),
                                       inputs.surfaces ? &inputs.surfaces->rayEnds() : &appearance->texels(),
                                       &appearance->numbers(), &appearance->colors()})
      bindings.emplace_back(*view);
  }
  const bool hasMethod = variant.integration.integration != Integration::Exact;
  if (hasMethod) {
    bindings.emplace_back(inputs.tables.numbers());
    bindings.emplace_back(inputs.tables.table2d());
    bindings.emplace_back(inputs.tables.table3d());
  }
  Walk& shaders = walk(variant);
  ComputeVariants& march = appearance ? shaders.marchAppearance : hasMethod ? shaders.marchMethods : shaders.march;
  commands.dispatchIndirect(march.get(constants), bindings, push, storage.counts(), kWalkTiles);
  commands.barrier(kComputeReadWrite, kComputeReadWrite | kTransferRead | kTransferWrite | kVertexRead);
}

void MarchPass::recordShow(gpu::CommandBuffer& commands, const MarchStorage& storage, const shared::PixelBand& band,
                           const gpu::AttachmentImage& target, bool clear) {
  if (target.format() == VK_FORMAT_R32G32B32A32_SFLOAT) {
    commands.copyToAttachment(storage.colors(), target, {band.firstRow, band.rowCount});
    return;
  }
  commands.beginRendering(target, clear, {band.firstRow, band.rowCount});
  commands.draw(showPipeline(target.format()), {storage.colorsView()}, band, 3);
  commands.endRendering();
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
