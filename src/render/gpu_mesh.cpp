#include "render/gpu_mesh.h"

#include <glm/vec4.hpp>
#include <span>

#include "base/error.h"
#include "base/parallel.h"
#include "mesh/vertex_buckets.h"

namespace tetralux::render {
namespace {

constexpr size_t kGrain = 1 << 16;

gpu::Buffer makeVertexBuffer(const gpu::Context& context, const TetMesh& mesh, const ScalarField& field,
                             const MeshSpace& space) {
  const bool hasScalar = field.association == FieldAssociation::Point;
  return gpu::makeBuffer<glm::vec4>(context, mesh.pointCount(), "mesh vertices",
                                    [&](std::span<glm::vec4> vertices, size_t first) {
                                      parallelFor(vertices.size(), kGrain, [&](size_t begin, size_t end, unsigned) {
                                        for (size_t i = begin; i < end; i++) {
                                          const size_t point = first + i;
                                          vertices[i] = glm::vec4(space.roundedPosition(mesh.point(point)),
                                                                  hasScalar ? space.scalar(field.values[point]) : 0.0f);
                                        }
                                      });
                                    });
}

// Vertices in ascending order: a cell is a set of points, and two cells that share a face then name it alike.
gpu::PiecedBuffer makeCellBuffer(const gpu::Context& context, const TetMesh& mesh, unsigned pieceBits) {
  return gpu::makePiecedBuffer<CellVertices>(
      context, mesh.cellCount(), pieceBits, "mesh cells", [&](std::span<CellVertices> cells, size_t first) {
        parallelFor(cells.size(), kGrain, [&](size_t begin, size_t end, unsigned) {
          for (size_t i = begin; i < end; i++) cells[i] = sortedVertices(mesh.cells[first + i]);
        });
      });
}

gpu::Buffer makeCellScalarBuffer(const gpu::Context& context, const ScalarField& field, const MeshSpace& space) {
  const size_t count = field.association == FieldAssociation::Cell ? field.values.size() : 0;
  return gpu::makeBuffer<float>(context, count, "cell scalars", [&](std::span<float> scalars, size_t first) {
    for (size_t i = 0; i < scalars.size(); i++) scalars[i] = space.scalar(field.values[first + i]);
  });
}

// Cell indices are 32 bits wide in the sort's values, and one is kept free.
std::uint32_t checkedCount(size_t count, const char* what) {
  constexpr size_t kLargest = 0xfffffffe;
  if (count > kLargest) fail(ErrorCode::Device, "mesh has {} {}, tetralux draws at most {}", count, what, kLargest);
  return static_cast<std::uint32_t>(count);
}

}  // namespace

GpuMesh::GpuMesh(const gpu::Context& context, const TetMesh& mesh, const ScalarField& field, unsigned pieceBits)
    : space_(makeMeshSpace(mesh, field)),
      cellCount_(checkedCount(mesh.cellCount(), "cells")),
      vertexCount_(checkedCount(mesh.pointCount(), "points")),
      isCellField_(field.association == FieldAssociation::Cell),
      vertexBuffer_(makeVertexBuffer(context, mesh, field, space_)),
      cellBuffer_(makeCellBuffer(context, mesh, pieceBits)),
      cellScalarBuffer_(makeCellScalarBuffer(context, field, space_)),
      vertexView_(context, vertexBuffer_, VK_FORMAT_R32G32B32A32_SFLOAT),
      cellView_(context, cellBuffer_.firstPiece(), VK_FORMAT_R32G32B32A32_UINT),
      cellScalarView_(context, cellScalarBuffer_, VK_FORMAT_R32_SFLOAT) {}

std::uint64_t GpuMesh::sizeBytes() const {
  return vertexBuffer_.sizeBytes() + cellBuffer_.sizeBytes() + cellScalarBuffer_.sizeBytes();
}

MeshAddresses GpuMesh::addresses() const {
  return {cellBuffer_.address(), vertexBuffer_.address(), cellScalarBuffer_.address()};
}

}  // namespace tetralux::render
