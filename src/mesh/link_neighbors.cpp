#include "mesh/link_neighbors.h"

#include <bit>

#include "mesh/adjacency.h"
#include "mesh/vertex_buckets.h"

namespace tetralux {
namespace {

constexpr size_t kPointsAtOnce = 1 << 12;

// The faces whose smallest vertex is one given point, in a hash table that stays within the first cache: cells are
// dealt out by point, not faces, and nothing is sorted.
class FaceTable {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::uint32_t kSeveral = 0xfffffffeu;  // more than two cells

  struct Face {
    std::uint32_t middle, last;  // its other vertices
    std::uint32_t opposite;      // the vertex of the first cell that the face has not
    std::uint32_t first;         // 4 cell + face
    std::uint32_t second = kNone;
  };

  void restart(size_t mostFaces) {
    faces_.clear();
    if (slots_.size() < 2 * mostFaces) {
      slots_.assign(std::bit_ceil(2 * mostFaces), {});
      round_ = 0;
    }
    if (++round_ == 0) {
      slots_.assign(slots_.size(), {});
      round_ = 1;
    }
  }

  void add(std::uint32_t middle, std::uint32_t last, std::uint32_t opposite, std::uint32_t cellFace) {
    const size_t mask = slots_.size() - 1;
    const std::uint64_t mixed = (std::uint64_t{middle} << 32 | last) * 0x9e3779b97f4a7c15u;
    for (size_t i = mixed >> 32 & mask;; i = (i + 1) & mask) {
      Slot& slot = slots_[i];
      if (slot.round != round_) {
        slot = {round_, static_cast<std::uint32_t>(faces_.size())};
        faces_.push_back({middle, last, opposite, cellFace});
        return;
      }
      Face& face = faces_[slot.face];
      if (face.middle != middle || face.last != last) continue;
      // A cell that is there twice lies behind none of its faces: each of the two has its own boundary.
      const bool isPair = face.second == kNone && face.opposite != opposite;
      face.second = isPair ? cellFace : kSeveral;
      return;
    }
  }

  const std::vector<Face>& faces() const { return faces_; }

 private:
  struct Slot {
    std::uint32_t round = 0;  // of another round: empty
    std::uint32_t face = 0;
  };

  std::vector<Slot> slots_;
  std::vector<Face> faces_;
  std::uint32_t round_ = 0;
};

}  // namespace

std::vector<std::array<std::uint32_t, 4>> linkNeighbors(
    const TetMesh& mesh, const std::function<void(std::uint32_t, std::uint32_t)>& onLink) {
  // 4 cell at the second smallest vertex, which is the smallest of face 0; 4 cell + 1 at the smallest, that of the
  // other three.
  auto buckets =
      VertexBuckets<std::uint32_t>::dealOut(mesh.cellCount(), mesh.pointCount(), [&](size_t cell, const auto& emit) {
        const CellVertices v = sortedVertices(mesh.cells[cell]);
        if (hasRepeatedVertex(v)) return;
        emit(v[1], static_cast<std::uint32_t>(4 * cell));
        emit(v[0], static_cast<std::uint32_t>(4 * cell + 1));
      });
  std::vector<std::array<std::uint32_t, 4>> neighbors(mesh.cellCount(), {kNoCell, kNoCell, kNoCell, kNoCell});
  std::vector<FaceTable> tables(workerCount());
  parallelFor(mesh.pointCount(), kPointsAtOnce, [&](size_t begin, size_t end, unsigned worker) {
    FaceTable& table = tables[worker];
    for (size_t point = begin; point < end; point++) {
      const auto entries = buckets.of(point);
      if (entries.empty()) continue;
      table.restart(3 * entries.size());
      for (const std::uint32_t entry : entries) {
        const std::uint32_t face0 = entry & ~3u;
        const CellVertices v = sortedVertices(mesh.cells[face0 / 4]);
        if (entry == face0) {
          table.add(v[2], v[3], v[0], face0);
          continue;
        }
        table.add(v[2], v[3], v[1], face0 + 1);
        table.add(v[1], v[3], v[2], face0 + 2);
        table.add(v[1], v[2], v[3], face0 + 3);
      }
      for (const FaceTable::Face& face : table.faces()) {
        if (face.second >= FaceTable::kSeveral) continue;
        neighbors[face.first / 4][face.first % 4] = face.second / 4;
        neighbors[face.second / 4][face.second % 4] = face.first / 4;
        onLink(face.first, face.second);
      }
    }
  });
  return neighbors;
}

}  // namespace tetralux
