#include "render/walk_topology.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "mesh/vertex_buckets.h"

namespace tetralux::render {
namespace {

constexpr size_t kGrain = 1 << 14;

// What is left when a cell's vertices are taken out of this is none of them.
std::uint32_t vertexXor(const TetMesh& mesh, std::uint32_t cell) {
  const auto& v = mesh.cells[cell];
  return v[0] ^ v[1] ^ v[2] ^ v[3];
}

using Across = std::array<std::uint32_t, 2>;

gpu::PiecedBuffer makeAcrossBuffer(const gpu::Context& context, const TetMesh& mesh, const Adjacency& adjacency,
                                   unsigned pieceBits) {
  using CellAcross = std::array<Across, 4>;
  return gpu::makePiecedBuffer<CellAcross>(
      context, mesh.cellCount(), pieceBits, "walk topology", [&](std::span<CellAcross> across, size_t first) {
        parallelFor(across.size(), kGrain, [&](size_t begin, size_t end, unsigned) {
          for (size_t i = begin; i < end; i++) {
            const auto cell = static_cast<std::uint32_t>(first + i);
            const CellVertices sorted = sortedVertices(mesh.cells[cell]);
            for (size_t k = 0; k < 4; k++) {
              const std::uint32_t next = adjacency.neighbors[cell][k];
              const std::uint32_t face = vertexXor(mesh, cell) ^ sorted[k];
              across[i][k] = {next, next == kNoCell ? 0 : vertexXor(mesh, next) ^ face};
            }
          }
        });
      });
}

// Four times the cell, plus the place among its vertices in ascending order of the one that the face does not have.
std::uint32_t faceCode(const TetMesh& mesh, const BoundaryFace& face) {
  const auto& [a, b, c] = face.vertices;
  const std::uint32_t opposite = vertexXor(mesh, face.cell) ^ a ^ b ^ c;
  return 4 * face.cell + static_cast<std::uint32_t>((a < opposite) + (b < opposite) + (c < opposite));
}

std::vector<std::array<std::uint32_t, 4>> listBoundary(const TetMesh& mesh, const Adjacency& adjacency) {
  std::vector<std::array<std::uint32_t, 4>> faces;
  faces.reserve(adjacency.boundary.size());
  for (const BoundaryFace& face : adjacency.boundary) {
    const auto& [a, b, c] = face.vertices;
    faces.push_back({a, b, c, faceCode(mesh, face)});
  }
  return faces;
}

std::vector<std::uint32_t> windingBits(const Adjacency& adjacency) {
  constexpr size_t kBits = 32;
  const size_t cells = adjacency.sides.size();
  std::vector<std::uint32_t> words((cells + kBits - 1) / kBits);
  parallelFor(words.size(), kGrain / kBits, [&](size_t begin, size_t end, unsigned) {
    for (size_t cell = begin * kBits; cell < std::min(end * kBits, cells); cell++)
      words[cell / kBits] |= static_cast<std::uint32_t>(adjacency.sides[cell] >> 1 & 1) << cell % kBits;
  });
  return words;
}

}  // namespace

WalkTopology::WalkTopology(const gpu::Context& context, const TetMesh& mesh, const Adjacency& adjacency,
                           unsigned pieceBits)
    : boundaryCount_(static_cast<std::uint32_t>(adjacency.boundary.size())),
      pieceBits_(pieceBits),
      acrossBuffer_(makeAcrossBuffer(context, mesh, adjacency, pieceBits)),
      boundaryBuffer_(gpu::makeBuffer(context, listBoundary(mesh, adjacency), "walk boundary")),
      windingBuffer_(gpu::makeBuffer(context, windingBits(adjacency), "windings")),
      acrossView_(context, acrossBuffer_.firstPiece(), VK_FORMAT_R32G32_UINT),
      boundaryView_(context, boundaryBuffer_, VK_FORMAT_R32G32B32A32_UINT),
      windingView_(context, windingBuffer_, VK_FORMAT_R32_UINT) {}

WalkTopology::WalkTopology(const gpu::Context& context, std::uint32_t cellCount, std::uint32_t boundaryCount,
                           unsigned pieceBits)
    : boundaryCount_(boundaryCount),
      pieceBits_(pieceBits),
      acrossBuffer_(context, cellCount, 32, pieceBits, "walk topology of what shows"),
      boundaryBuffer_(context, std::uint64_t{16} * std::max(boundaryCount, 1u), gpu::MemoryKind::Device,
                      "boundary of what shows"),
      acrossView_(context, acrossBuffer_.firstPiece(), VK_FORMAT_R32G32_UINT),
      boundaryView_(context, boundaryBuffer_, VK_FORMAT_R32G32B32A32_UINT) {}

std::uint64_t WalkTopology::sizeBytes() const {
  return acrossBuffer_.sizeBytes() + boundaryBuffer_.sizeBytes() + windingBuffer_.sizeBytes();
}

}  // namespace tetralux::render
