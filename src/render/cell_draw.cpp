#include "render/cell_draw.h"

#include "render/shader_library.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

// Of shaders that read the mesh themselves.
struct MeshPush {
  shared::CellPush cells;
  MeshAddresses mesh;
  VkDeviceAddress order;
};

}  // namespace

CellDraw::CellDraw(const gpu::Context& context, const std::string& fans, const std::string& gator,
                   const std::string& appearance)
    : context_(context),
      fans_{"raster/fan.vert", fans, {}, {}},
      gator_{"raster/gator.vert", gator, {}, {}},
      appearance_{"raster/fan.vert", appearance, {}, {}} {}

void CellDraw::Shaders::load(const gpu::Context& context) {
  if (vertex) return;
  vertex.emplace(loadShader(context, vertexName));
  fragment.emplace(loadShader(context, fragmentName));
}

std::vector<gpu::Descriptor> CellDraw::bindings(const FrameVariant& variant, const CellBatch& batch) const {
  const TransferBuffer& transfer = batch.transfer;
  if (const AppearanceBuffer* appearance = batch.appearance)
    return {batch.storage.modesView,  batch.view,
            transfer.pieces(),        transfer.pieceBins(),
            batch.mesh.cells(),       batch.mesh.vertices(),
            batch.mesh.cellScalars(), *batch.sequence.orderView,
            appearance->points(),     appearance->pointScalars(),
            appearance->texels(),     appearance->gradients(),
            appearance->texels(),  // no ray ends at a surface
            appearance->numbers(),    appearance->colors()};
  std::vector<gpu::Descriptor> result;
  if (variant.gator)
    result = {batch.view,
              batch.mesh.cells(),
              batch.mesh.vertices(),
              batch.mesh.cellScalars(),
              batch.truthTable.view,
              *batch.sequence.orderView,
              transfer.largestExtinction()};
  else
    result = {batch.storage.modesView, batch.storage.endsView};
  result.insert(result.end(), {transfer.pieces(), transfer.pieceBins(), batch.tables.numbers(), batch.tables.table2d(),
                               batch.tables.table3d()});
  return result;
}

void CellDraw::record(gpu::CommandBuffer& commands, const FrameVariant& variant, const CellBatch& batch,
                      VkFormat format, std::uint32_t kBuffer, const std::vector<gpu::Descriptor>& further) {
  const BatchStorage& storage = batch.storage;
  std::vector<gpu::Descriptor> descriptors = bindings(variant, batch);
  descriptors.insert(descriptors.end(), further.begin(), further.end());

  const gpu::GraphicsPipeline& cells = pipeline(variant, batch.appearance, format, kBuffer);
  constexpr std::uint64_t kArguments = offsetof(shared::BatchArguments, indexCount);
  const MeshPush meshPush{batch.push, batch.mesh.addresses(), batch.sequence.order->address()};
  const gpu::Buffer* const streams[] = {&storage.positions, &storage.ends};
  if (variant.gator)
    commands.drawIndexedIndirect(cells, descriptors, meshPush, {}, storage.indices, storage.arguments, kArguments);
  else if (batch.appearance)
    commands.drawIndexedIndirect(cells, descriptors, meshPush, streams, storage.indices, storage.arguments, kArguments);
  else
    commands.drawIndexedIndirect(cells, descriptors, batch.push, streams, storage.indices, storage.arguments,
                                 kArguments);
}

const gpu::GraphicsPipeline& CellDraw::pipeline(const FrameVariant& variant, const AppearanceBuffer* appearance,
                                                VkFormat format, std::uint32_t kBuffer) {
  gpu::SpecConstants constants = variant.integration.specConstants();
  constants.push_back({SPEC_EMISSION_PER_LENGTH, variant.emissionPerLength});
  constants.push_back({SPEC_OUTPUT, variant.output});
  constants.push_back({SPEC_KBUFFER, kBuffer});
  constants.push_back({SPEC_SUBPIXELS, variant.silhouette ? 0 : variant.subpixels});  // outlines interpolate nothing
  const auto add = [&](const gpu::SpecConstants& more) { constants.insert(constants.end(), more.begin(), more.end()); };
  // Shaders of fans are the same whatever the mesh: what projected them has dealt with that.
  if (variant.gator || appearance) {
    add(variant.specConstants());
  } else {
    constants.push_back({SPEC_PERSPECTIVE, variant.perspective});
    constants.push_back({SPEC_SILHOUETTE, variant.silhouette});
  }
  if (appearance) add(appearance->specConstants());
  std::vector<std::uint32_t> key = {variant.gator, appearance != nullptr, static_cast<std::uint32_t>(format)};
  for (const gpu::SpecConstant& constant : constants) key.push_back(constant.value);
  const auto found = pipelines_.find(key);
  if (found != pipelines_.end()) return found->second;
  gpu::GraphicsState state;
  if (!variant.gator) state.streams = {{VK_FORMAT_R32G32_SFLOAT, 8}, {VK_FORMAT_R32G32B32A32_SFLOAT, 16}};
  state.colorFormat = format;
  Shaders& shaders = variant.gator ? gator_ : appearance ? appearance_ : fans_;
  shaders.load(context_);
  return pipelines_
      .emplace(std::move(key), gpu::GraphicsPipeline(context_, *shaders.vertex, *shaders.fragment, state, constants))
      .first->second;
}

}  // namespace tetralux::render
