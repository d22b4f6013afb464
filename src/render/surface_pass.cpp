#include "render/surface_pass.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/error.h"
#include "shared/appearance.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

using namespace gpu::access;
using gpu::MemoryKind;
using shared::MarchCounts;

constexpr std::uint32_t kFewestJobs = 1u << 14;

struct BinPush {
  MeshAddresses mesh{};  // not used: surfaces are reached through texel buffers
  VkDeviceAddress boundary = 0;
  shared::PixelBand band;
  std::uint32_t faceCount;
  std::uint32_t jobCapacity;
};

struct MeetPush {
  shared::PixelBand band;
  std::uint32_t jobCapacity;
};

}  // namespace

SurfaceStorage::SurfaceStorage(const gpu::Context& context, const std::vector<OpaqueSurface>& surfaces,
                               const MeshSpace& space)
    : context_(context) {
  std::vector<glm::vec4> vertices;
  std::vector<glm::vec4> normals;
  std::vector<std::array<std::uint32_t, 4>> triangles;
  std::vector<glm::vec4> materials;
  for (std::uint32_t i = 0; i < surfaces.size(); i++) {
    const OpaqueSurface& surface = surfaces[i];
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (size_t v = 0; v < surface.points.size(); v++) {
      vertices.emplace_back(space.roundedPosition(surface.points[v]), 0.0f);
      normals.emplace_back(surface.normals.empty() ? glm::vec3(0.0f) : glm::vec3(surface.normals[v]), 0.0f);
    }
    for (const auto& [a, b, c] : surface.triangles) triangles.push_back({first + a, first + b, first + c, i});
    materials.emplace_back(glm::vec3(surface.rgb), static_cast<float>(surface.shading));
    materials.emplace_back(glm::vec3(surface.backRgb), 0.0f);
  }
  const std::uint64_t most = context.info().largestTexelBuffer;
  if (std::max(vertices.size(), triangles.size()) > most)
    fail(ErrorCode::Device, "surfaces have {} points and {} triangles, expected at most {} on this device",
         vertices.size(), triangles.size(), most);
  triangleCount_ = static_cast<std::uint32_t>(triangles.size());
  jobCapacity_ = std::max(2 * triangleCount_, kFewestJobs);
  vertices_ = gpu::makeBuffer(context, vertices, "surface vertices");
  normals_ = gpu::makeBuffer(context, normals, "surface normals");
  triangles_ = gpu::makeBuffer(context, triangles, "surface triangles");
  materials_ = gpu::makeBuffer(context, materials, "surface materials");
  counts_ = gpu::Buffer(context, sizeof(MarchCounts), MemoryKind::Device, "surface counts");
  vertexView_ = gpu::TexelView(context, vertices_, VK_FORMAT_R32G32B32A32_SFLOAT);
  normalView_ = gpu::TexelView(context, normals_, VK_FORMAT_R32G32B32A32_SFLOAT);
  triangleView_ = gpu::TexelView(context, triangles_, VK_FORMAT_R32G32B32A32_UINT);
  materialView_ = gpu::TexelView(context, materials_, VK_FORMAT_R32G32B32A32_SFLOAT);
}

void SurfaceStorage::prepare(std::uint64_t pixels, std::uint64_t tiles) {
  if (jobs_.sizeBytes() < std::uint64_t{16} * jobCapacity_) {
    jobsView_ = {};
    jobs_ = {};
    jobs_ = gpu::Buffer(context_, std::uint64_t{16} * jobCapacity_, MemoryKind::Device, "surface jobs");
    jobsView_ = gpu::TexelView(context_, jobs_, VK_FORMAT_R32G32B32A32_UINT);
  }
  if (rayEnds_.sizeBytes() >= 16 * pixels && tiles_.sizeBytes() >= 4 * tiles) return;
  rayEndsView_ = {};
  const auto make = [&](gpu::Buffer& buffer, std::uint64_t bytes, const char* name) {
    buffer = {};
    buffer = gpu::Buffer(context_, bytes, MemoryKind::Device, name);
  };
  make(tileMarks_, 4 * tiles, "surface tile marks");
  make(tiles_, 4 * tiles, "surface tiles");
  make(nearest_, 4 * pixels, "surface depths");
  make(chosen_, 4 * pixels, "surface choices");
  make(rayEnds_, 16 * pixels, "ray ends");
  rayEndsView_ = gpu::TexelView(context_, rayEnds_, VK_FORMAT_R32G32B32A32_SFLOAT);
}

bool SurfaceStorage::grow() {
  MarchCounts counts{};
  gpu::download(context_, counts_, &counts, sizeof counts);
  if (counts.jobs <= jobCapacity_) return false;
  jobCapacity_ = counts.jobs + counts.jobs / 4;
  return true;
}

std::uint64_t SurfaceStorage::sizeBytes() const {
  std::uint64_t bytes = 0;
  for (const gpu::Buffer* buffer : {&vertices_, &normals_, &triangles_, &materials_, &counts_, &jobs_, &tileMarks_,
                                    &tiles_, &nearest_, &chosen_, &rayEnds_})
    bytes += buffer->sizeBytes();
  return bytes;
}

SurfacePass::SurfacePass(const gpu::Context& context)
    : bin_(context, "march/bin.comp"),
      meet_(context, "surface/meet.comp"),
      shade_(context, "surface/shade.comp"),
      behind_(context, "surface/behind.comp") {}

void SurfacePass::record(gpu::CommandBuffer& commands, const FrameVariant& variant, const AppearanceBuffer& appearance,
                         const gpu::Buffer& view, const SurfaceStorage& s, const shared::PixelBand& band) {
  commands.fill(s.counts_, 0);
  commands.fill(s.tileMarks_, 0);
  commands.fill(s.nearest_, 0xffffffffu);
  commands.fill(s.chosen_, shared::NO_TRIANGLE);
  commands.barrier(kTransferWrite, kTransferWrite);
  commands.fill(s.counts_, 1, offsetof(MarchCounts, jobGroupsY), 2 * sizeof(std::uint32_t));
  commands.barrier(kTransferWrite, kComputeReadWrite | kIndirectRead);

  // Both sides of a triangle are seen, and it may be anywhere about the eye: the near cells' path has both.
  const gpu::SpecConstants binConstants{
      {SPEC_WIDE_ADDRESSING, 0}, {SPEC_PERSPECTIVE, variant.perspective}, {SPEC_NEAR_CELLS, 1}};
  const BinPush binPush{{}, 0, band, s.triangleCount_, s.jobCapacity_};
  commands.dispatch(bin_.get(binConstants),
                    {view, s.triangleView_, s.vertexView_, s.vertexView_, s.triangleView_, s.jobs_, s.tileMarks_,
                     s.tiles_, s.counts_},
                    binPush, s.triangleCount_);
  commands.barrier(kComputeWrite, kComputeReadWrite | kIndirectRead);

  const MeetPush meetPush{band, s.jobCapacity_};
  for (const bool choose : {false, true}) {
    commands.dispatchIndirect(
        meet_.get({{SPEC_PERSPECTIVE, variant.perspective}, {SPEC_CHOOSE_TRIANGLE, choose}}),
        {view, s.vertexView_, s.triangleView_, s.jobsView_, s.counts_, s.tiles_, s.nearest_, s.chosen_}, meetPush,
        s.counts_, offsetof(MarchCounts, jobGroups));
    commands.barrier(kComputeReadWrite, kComputeReadWrite);
  }

  gpu::SpecConstants constants = appearance.specConstants();
  constants.push_back({SPEC_PERSPECTIVE, variant.perspective});
  commands.dispatch(shade_.get(constants),
                    {view, s.vertexView_, appearance.texels(), s.triangleView_, s.normalView_, s.materialView_,
                     s.chosen_, s.rayEnds_},
                    band, band.width * band.rowCount);
  commands.barrier(kComputeWrite, kComputeReadWrite | kTransferWrite);
}

void SurfacePass::recordBehind(gpu::CommandBuffer& commands, const SurfaceStorage& storage, const gpu::Buffer& colors,
                               const shared::PixelBand& band) {
  commands.dispatch(behind_.get({}), {storage.rayEndsView_, colors}, band, band.width * band.rowCount);
  commands.barrier(kComputeReadWrite, kComputeReadWrite | kTransferRead | kTransferWrite | kVertexRead);
}

}  // namespace tetralux::render
