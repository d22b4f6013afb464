#include "render/renderer.h"

#include <glm/gtc/packing.hpp>

#include "base/check.h"
#include "base/parallel.h"
#include "mesh/adjacency.h"
#include "mesh/overlaps.h"
#include "render/order/make_order.h"

namespace tetralux::render {
namespace {

VkFormat formatOf(Target target) {
  return target == Target::Rgba32f ? VK_FORMAT_R32G32B32A32_SFLOAT : VK_FORMAT_R16G16B16A16_SFLOAT;
}

// Whether a buffer of the frame or mesh is longer than texel buffers or storage descriptors reach.
bool needsWideAddressing(const gpu::DeviceInfo& info, const GpuMesh& mesh) {
  const std::uint64_t longest = std::max(mesh.cellCount(), mesh.vertexCount());
  return longest > info.largestTexelBuffer || std::uint64_t{4} * mesh.cellCount() > info.largestStorageRangeBytes;
}

SortVariant sortVariant(const gpu::Context& context, const RendererOptions& options) {
  return options.sortVariant.value_or(bestSortVariant(context.info()));
}

}  // namespace

const char* targetName(Target target) { return target == Target::Rgba32f ? "rgba32f" : "rgba16f"; }

Renderer::Renderer(const gpu::Context& context, const TetMesh& mesh, const ScalarField& field,
                   const RendererOptions& options)
    : context_(context),
      mesh_(context, mesh, field),
      wideAddressing_(options.forceWideAddressing || needsWideAddressing(context.info(), mesh_)),
      checkOrder_(options.checkOrder),
      passes_(context),
      storage_(context, mesh_.cellCount(), sortVariant(context, options)) {
  if (options.checkOrder || needsVisibility(options.order)) {
    const Adjacency adjacency = makeAdjacency(mesh);
    visibility_ = std::make_unique<VisibilityKit>(context, adjacency, findOverlaps(mesh, adjacency));
  }
  order_ = makeOrder(context, options.order, options.kBuffer, sortVariant(context, options), visibility_.get());
}

void Renderer::setTransferFunction(const TransferFunction& transfer) {
  transfer_ = std::make_unique<TransferBuffer>(context_, transfer, mesh_.space());
}

FrameStats Renderer::draw(const Camera& camera, ImageSize size, const RenderOptions& options) {
  CHECK(transfer_ != nullptr);
  const FrameSetup setup =
      makeFrameSetup(camera, size, mesh_.space(), mesh_.cellCount(), transfer_->supportCount(), kCentroidKeyBits);
  const VkFormat format = formatOf(options.target);
  if (!target_ || target_->width() != size.width || target_->height() != size.height || target_->format() != format) {
    readback_.reset();
    target_.reset();
    target_ = std::make_unique<gpu::AttachmentImage>(context_, size.width, size.height, format, "target");
  }
  gpu::upload(context_, storage_.view, &setup.view, sizeof setup.view);

  FrameVariant variant;
  variant.perspective = setup.perspective;
  variant.cellField = mesh_.isCellField();
  variant.nearCells = setup.nearCells;
  variant.wideAddressing = wideAddressing_;
  gpu::Recorder recorder(context_, options.timed ? gpu::bestTiming(context_.info()) : gpu::PassTiming::Off);
  const OrderReport order = drawFrame(recorder, {context_, mesh_, *transfer_, setup, variant, size, checkOrder_},
                                      passes_, *order_, storage_, *target_);

  shared::FrameCounters counters;
  gpu::download(context_, storage_.counters, &counters, sizeof counters);
  FrameStats stats;
  stats.drawnCells = counters.drawn;
  stats.triangles = counters.triangles;
  stats.clippedCells = counters.clipped;
  stats.culledOutside = counters.outside;
  stats.culledNoSample = counters.noSample;
  stats.culledTransparent = counters.transparent;
  stats.order = order;
  stats.passes = recorder.passTimes();
  stats.frameMs = recorder.totalMs();
  return stats;
}

Image Renderer::readImage(FrameStats* stats) {
  CHECK(target_ != nullptr);
  Image image(target_->width(), target_->height());
  const bool isHalf = target_->format() == VK_FORMAT_R16G16B16A16_SFLOAT;
  const std::uint64_t bytes = image.pixels.size() * (isHalf ? sizeof(std::uint64_t) : sizeof(glm::vec4));
  if (!readback_) readback_ = std::make_unique<gpu::Buffer>(context_, bytes, gpu::MemoryKind::Readback, "readback");
  gpu::CommandBuffer commands(context_);
  commands.copyToBuffer(*target_, *readback_);
  commands.barrier(gpu::access::kTransferWrite, gpu::access::kHostRead);
  const double milliseconds = commands.submitAndWait();
  if (stats) stats->readbackMs = milliseconds;
  if (isHalf) {
    const auto packed = readback_->as<std::uint64_t>();
    for (size_t i = 0; i < image.pixels.size(); i++) image.pixels[i] = glm::unpackHalf4x16(packed[i]);
  } else {
    const auto pixels = readback_->as<glm::vec4>();
    std::copy_n(pixels.begin(), image.pixels.size(), image.pixels.begin());
  }
  return image;
}

MemoryUse Renderer::memoryUse() const {
  MemoryUse use;
  use.meshBytes = mesh_.sizeBytes();
  use.frameBytes =
      storage_.sizeBytes() + (target_ ? target_->sizeBytes() : 0) + (readback_ ? readback_->sizeBytes() : 0);
  use.orderBytes = order_->sizeBytes() + (visibility_ ? visibility_->sizeBytes() : 0);
  use.tableBytes = transfer_ ? transfer_->sizeBytes() : 0;
  return use;
}

}  // namespace tetralux::render
