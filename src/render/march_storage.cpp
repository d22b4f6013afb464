#include "render/march_storage.h"

#include <algorithm>
#include <cstddef>
#include <glm/vec4.hpp>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.h"

namespace tetralux::render {
namespace {

using gpu::MemoryKind;
using shared::MarchCounts;

constexpr size_t kGrain = 1 << 16;
constexpr std::uint32_t kFewestJobs = 1u << 14;
constexpr std::uint32_t kFewestNodes = 1u << 16;
// Buffers of up to 64 MiB, which every device's descriptors reach.
constexpr std::uint32_t kMostJobs = 1u << 22;
constexpr std::uint32_t kMostNodes = 1u << 23;

std::uint32_t tileCount(std::uint32_t pixels) { return (pixels + shared::MARCH_TILE - 1) / shared::MARCH_TILE; }

// Room for a quarter more than was wanted: the next frame of a sequence is a little different.
std::uint32_t enlarged(std::uint32_t capacity, std::uint32_t wanted, std::uint32_t most, bool isLastResort) {
  if (wanted <= capacity) return capacity;
  const std::uint64_t more = wanted + std::uint64_t{wanted} / 4;
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(more, isLastResort ? 0xfffffffeu : most));
}

gpu::Buffer makeRestBuffer(const gpu::Context& context, const TetMesh& mesh, const MeshSpace& space) {
  constexpr const char* kName = "vertex rests";
  if (!context.info().hasFloat64) return gpu::makeBuffer(context, std::vector<glm::vec4>(1), kName);
  return gpu::makeBuffer<glm::vec4>(context, mesh.pointCount(), kName, [&](std::span<glm::vec4> rests, size_t first) {
    parallelFor(rests.size(), kGrain, [&](size_t begin, size_t end, unsigned) {
      for (size_t i = begin; i < end; i++) rests[i] = glm::vec4(space.positionRest(mesh.point(first + i)), 0.0f);
    });
  });
}

}  // namespace

MarchStorage::MarchStorage(const gpu::Context& context, const TetMesh& mesh, const MeshSpace& space,
                           const Adjacency& adjacency, unsigned pieceBits)
    : context_(context),
      topology_(context, mesh, adjacency, pieceBits),
      restBuffer_(makeRestBuffer(context, mesh, space)),
      restView_(context, restBuffer_, VK_FORMAT_R32G32B32A32_SFLOAT),
      view_(context, sizeof(shared::FrameView), MemoryKind::Device, "frame view"),
      counts_(context, sizeof(MarchCounts), MemoryKind::Device, "march counts"),
      hostCounts_(context, sizeof(MarchCounts), MemoryKind::Readback, "march counts on the host") {}

void MarchStorage::prepare(ImageSize size, std::uint32_t boundaryCount) {
  if (size_.width == size.width && size_.height == size.height) return;
  size_ = size;
  bandRows_ = std::clamp(shared::MARCH_BAND_PIXELS / size.width, 1u, size.height);
  // A ray enters and leaves most meshes once.
  room_.nodes = std::clamp(2 * size.width * bandRows_, kFewestNodes, kMostNodes);
  room_.jobs = std::clamp(2 * boundaryCount, kFewestJobs, kMostJobs);
  allocate();
}

void MarchStorage::allocate() {
  // A failure leaves room for no picture at all.
  const ImageSize size = std::exchange(size_, {0, 0});
  // The old buffers go first: both may not fit.
  jobsView_ = {};
  colorsView_ = {};
  for (gpu::Buffer* buffer : {&jobs_, &tileMarks_, &walkTiles_, &sortTiles_, &heads_, &links_, &ranks_, &colors_})
    *buffer = {};
  const std::uint64_t pixels = std::uint64_t{size.width} * bandRows_;
  const std::uint64_t tiles = std::uint64_t{tileCount(size.width)} * tileCount(bandRows_);
  gpu::requireMemory(context_,
                     std::uint64_t{16} * room_.jobs + 12 * tiles + std::uint64_t{12} * room_.nodes + 20 * pixels,
                     "the picture's lists of faces");
  const auto make = [&](std::uint64_t bytes, const char* name) {
    return gpu::Buffer(context_, bytes, MemoryKind::Device, name);
  };
  jobs_ = make(std::uint64_t{16} * room_.jobs, "march jobs");
  tileMarks_ = make(4 * tiles, "march tile marks");
  walkTiles_ = make(4 * tiles, "march tiles");
  sortTiles_ = make(4 * tiles, "march tiles to sort");
  heads_ = make(4 * pixels, "march heads");
  links_ = make(std::uint64_t{4} * room_.nodes, "march links");
  ranks_ = make(std::uint64_t{8} * room_.nodes, "march ranks");
  colors_ = make(16 * pixels, "march colors");
  jobsView_ = gpu::TexelView(context_, jobs_, VK_FORMAT_R32G32B32A32_UINT);
  colorsView_ = gpu::TexelView(context_, colors_, VK_FORMAT_R32G32B32A32_SFLOAT);
  size_ = size;
}

shared::PixelBand MarchStorage::bandFrom(std::uint32_t firstRow) const {
  return {size_.width, firstRow, std::min(bandRows_, size_.height - firstRow), 0, room_.nodes};
}

std::uint64_t MarchStorage::bandPixels() const { return std::uint64_t{size_.width} * bandRows_; }

std::uint64_t MarchStorage::bandTiles() const { return std::uint64_t{tileCount(size_.width)} * tileCount(bandRows_); }

void MarchStorage::recordClear(gpu::CommandBuffer& commands) const {
  commands.fill(counts_, 0);
  commands.fill(tileMarks_, 0);
  commands.fill(heads_, shared::NO_NODE);
  commands.fill(colors_, 0);
  commands.barrier(gpu::access::kTransferWrite, gpu::access::kTransferWrite);
  for (const size_t groups :
       {offsetof(MarchCounts, jobGroupsY), offsetof(MarchCounts, walkTilesY), offsetof(MarchCounts, sortTilesY)})
    commands.fill(counts_, 1, groups, 2 * sizeof(std::uint32_t));
}

void MarchStorage::recordClearUnfinished(gpu::CommandBuffer& commands) const {
  commands.fill(counts_, 0, offsetof(MarchCounts, unfinished), sizeof(std::uint32_t));
  commands.barrier(gpu::access::kTransferWrite, gpu::access::kComputeReadWrite | gpu::access::kIndirectRead);
}

void MarchStorage::recordReadCounts(gpu::CommandBuffer& commands, const gpu::Buffer& hostCounts) const {
  commands.copy(counts_, 0, hostCounts, 0, sizeof(MarchCounts));
  commands.barrier(gpu::access::kTransferWrite, gpu::access::kHostRead);
}

bool MarchStorage::grow(const MarchCounts& counts) {
  if (room_.holds(counts)) return false;
  const bool isLastResort = bandRows_ == 1;
  room_.jobs = enlarged(room_.jobs, counts.jobs, kMostJobs, isLastResort);
  room_.nodes = enlarged(room_.nodes, counts.nodes, kMostNodes, isLastResort);
  if (!room_.holds(counts)) bandRows_ = std::max(1u, bandRows_ / 2);
  allocate();
  return true;
}

std::uint64_t MarchStorage::sizeBytes() const {
  std::uint64_t bytes = topology_.sizeBytes() + restBuffer_.sizeBytes() + view_.sizeBytes() + counts_.sizeBytes() +
                        hostCounts_.sizeBytes();
  for (const gpu::Buffer* buffer : {&jobs_, &tileMarks_, &walkTiles_, &sortTiles_, &heads_, &links_, &ranks_, &colors_})
    bytes += buffer->sizeBytes();
  return bytes;
}

}  // namespace tetralux::render
