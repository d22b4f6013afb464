#include "render/gpu_topology.h"

#include <vector>

namespace tetralux::render {
namespace {

std::vector<std::uint32_t> listVertices(const Adjacency& adjacency) {
  std::vector<std::uint32_t> vertices;
  vertices.reserve(adjacency.boundary.size() * 3);
  for (const BoundaryFace& face : adjacency.boundary)
    vertices.insert(vertices.end(), face.vertices.begin(), face.vertices.end());
  return vertices;
}

std::vector<std::uint32_t> listCells(const Adjacency& adjacency) {
  std::vector<std::uint32_t> cells;
  cells.reserve(adjacency.boundary.size());
  for (const BoundaryFace& face : adjacency.boundary) cells.push_back(face.cell);
  return cells;
}

// A texel view needs one element.
std::vector<std::array<std::uint32_t, 2>> atLeastOne(std::vector<std::array<std::uint32_t, 2>> pairs) {
  if (pairs.empty()) pairs.push_back({0, 0});
  return pairs;
}

}  // namespace

GpuTopology::GpuTopology(const gpu::Context& context, const Adjacency& adjacency,
                         const std::vector<std::array<std::uint32_t, 2>>& overlaps)
    : isConvex_(adjacency.isConvex),
      boundaryCount_(static_cast<std::uint32_t>(adjacency.boundary.size())),
      overlapCount_(static_cast<std::uint32_t>(overlaps.size())),
      neighborBuffer_(gpu::makeBuffer(context, adjacency.neighbors, "topology neighbors")),
      sideBuffer_(gpu::makeBuffer(context, adjacency.sides, "topology sides")),
      boundaryVertexBuffer_(gpu::makeBuffer(context, listVertices(adjacency), "boundary vertices")),
      boundaryCellBuffer_(gpu::makeBuffer(context, listCells(adjacency), "boundary cells")),
      overlapBuffer_(gpu::makeBuffer(context, atLeastOne(overlaps), "overlapping cells")),
      neighborView_(context, neighborBuffer_, VK_FORMAT_R32G32B32A32_UINT),
      sideView_(context, sideBuffer_, VK_FORMAT_R8_UINT),
      boundaryVertexView_(context, boundaryVertexBuffer_, VK_FORMAT_R32_UINT),
      boundaryCellView_(context, boundaryCellBuffer_, VK_FORMAT_R32_UINT),
      overlapView_(context, overlapBuffer_, VK_FORMAT_R32G32_UINT) {}

std::uint64_t GpuTopology::sizeBytes() const {
  return neighborBuffer_.sizeBytes() + sideBuffer_.sizeBytes() + boundaryVertexBuffer_.sizeBytes() +
         boundaryCellBuffer_.sizeBytes() + overlapBuffer_.sizeBytes();
}

}  // namespace tetralux::render
