#include "render/cell_draw.h"

#include "render/shader_library.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

struct GatorPush {
  shared::CellPush cells;
  MeshAddresses mesh;
  VkDeviceAddress order;
};

}  // namespace

CellDraw::CellDraw(const gpu::Context& context, const std::string& fans, const std::string& gator)
    : context_(context),
      fans_{loadShader(context, "raster/fan.vert"), loadShader(context, fans)},
      gator_{loadShader(context, "raster/gator.vert"), loadShader(context, gator)} {}

void CellDraw::record(gpu::CommandBuffer& commands, const FrameVariant& variant, const CellBatch& batch,
                      VkFormat format, std::uint32_t kBuffer, const std::vector<gpu::Descriptor>& further) {
  const BatchStorage& storage = batch.storage;
  const TransferBuffer& transfer = batch.transfer;
  std::vector<gpu::Descriptor> bindings;
  if (variant.gator)
    bindings = {batch.view,
                batch.mesh.cells(),
                batch.mesh.vertices(),
                batch.mesh.cellScalars(),
                batch.truthTable.view,
                *batch.sequence.orderView,
                transfer.largestExtinction()};
  else
    bindings = {storage.modesView, storage.endsView};
  bindings.insert(bindings.end(), {transfer.pieces(), transfer.pieceBins(), batch.tables.numbers(),
                                   batch.tables.table2d(), batch.tables.table3d()});
  bindings.insert(bindings.end(), further.begin(), further.end());

  const gpu::GraphicsPipeline& cells = pipeline(variant, format, kBuffer);
  constexpr std::uint64_t kArguments = offsetof(shared::BatchArguments, indexCount);
  if (variant.gator) {
    const GatorPush push{batch.push, batch.mesh.addresses(), batch.sequence.order->address()};
    commands.drawIndexedIndirect(cells, bindings, push, {}, storage.indices, storage.arguments, kArguments);
  } else {
    const gpu::Buffer* const streams[] = {&storage.positions, &storage.ends};
    commands.drawIndexedIndirect(cells, bindings, batch.push, streams, storage.indices, storage.arguments, kArguments);
  }
}

const gpu::GraphicsPipeline& CellDraw::pipeline(const FrameVariant& variant, VkFormat format, std::uint32_t kBuffer) {
  gpu::SpecConstants constants = variant.integration.specConstants();
  constants.push_back({SPEC_EMISSION_PER_LENGTH, variant.emissionPerLength});
  constants.push_back({SPEC_OUTPUT, variant.output});
  constants.push_back({SPEC_KBUFFER, kBuffer});
  constants.push_back({SPEC_SUBPIXELS, variant.silhouette ? 0 : variant.subpixels});  // outlines interpolate nothing
  // Shaders of fans are the same whatever the mesh: what projected them has dealt with that.
  if (variant.gator) {
    const gpu::SpecConstants projecting = variant.specConstants();
    constants.insert(constants.end(), projecting.begin(), projecting.end());
  } else {
    constants.push_back({SPEC_PERSPECTIVE, variant.perspective});
    constants.push_back({SPEC_SILHOUETTE, variant.silhouette});
  }
  std::vector<std::uint32_t> key = {variant.gator, static_cast<std::uint32_t>(format)};
  for (const gpu::SpecConstant& constant : constants) key.push_back(constant.value);
  const auto found = pipelines_.find(key);
  if (found != pipelines_.end()) return found->second;
  gpu::GraphicsState state;
  if (!variant.gator) state.streams = {{VK_FORMAT_R32G32_SFLOAT, 8}, {VK_FORMAT_R32G32B32A32_SFLOAT, 16}};
  state.colorFormat = format;
  const Shaders& shaders = variant.gator ? gator_ : fans_;
  return pipelines_
      .emplace(std::move(key), gpu::GraphicsPipeline(context_, shaders.vertex, shaders.fragment, state, constants))
      .first->second;
}

}  // namespace tetralux::render
