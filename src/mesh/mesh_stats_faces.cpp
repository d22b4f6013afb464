#include "mesh/mesh_stats_faces.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <utility>

#include "base/parallel.h"

namespace tetralux {
namespace {

constexpr size_t kPointsAtOnce = 1 << 12;

// How many different keys there are, by how often they occur.
struct GroupCounts {
  std::uint64_t once = 0;
  std::uint64_t twice = 0;
  std::uint64_t oftener = 0;
};

template <typename Key>
GroupCounts countGroups(VertexBuckets<Key>& buckets) {
  GroupCounts sum;
  std::mutex mutex;
  parallelFor(buckets.ends.size(), kPointsAtOnce, [&](size_t begin, size_t end, unsigned) {
    GroupCounts counts;
    for (size_t point = begin; point < end; point++) {
      const std::span<Key> keys = buckets.of(point);
      std::sort(keys.begin(), keys.end());
      for (size_t i = 0; i < keys.size();) {
        size_t next = i + 1;
        while (next < keys.size() && keys[next] == keys[i]) next++;
        (next - i == 1 ? counts.once : next - i == 2 ? counts.twice : counts.oftener)++;
        i = next;
      }
    }
    const std::lock_guard lock(mutex);
    sum.once += counts.once;
    sum.twice += counts.twice;
    sum.oftener += counts.oftener;
  });
  return sum;
}

std::uint64_t pairKey(std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; }

}  // namespace

FaceCounts countFaces(std::span<const CellVertices> cells, size_t pointCount) {
  auto buckets = VertexBuckets<std::uint64_t>::dealOut(cells.size(), pointCount, [&](size_t cell, const auto& emit) {
    const CellVertices v = sortedVertices(cells[cell]);
    emit(v[0], pairKey(v[1], v[2]));
    emit(v[0], pairKey(v[1], v[3]));
    emit(v[0], pairKey(v[2], v[3]));
    emit(v[1], pairKey(v[2], v[3]));
  });
  const GroupCounts groups = countGroups(buckets);
  return {groups.once, groups.twice, groups.oftener};
}

std::uint64_t countDuplicateCells(std::span<const CellVertices> cells, size_t pointCount) {
  using Key = std::array<std::uint32_t, 3>;
  auto buckets = VertexBuckets<Key>::dealOut(cells.size(), pointCount, [&](size_t cell, const auto& emit) {
    const CellVertices v = sortedVertices(cells[cell]);
    emit(v[0], Key{v[1], v[2], v[3]});
  });
  const GroupCounts groups = countGroups(buckets);
  return cells.size() - (groups.once + groups.twice + groups.oftener);
}

}  // namespace tetralux
