// Faces and cells are told apart by their sorted vertices. They are first dealt out to buckets by the smallest one (a
// counting sort); what is left to sort is small: the faces of one vertex.
#include "mesh/mesh_stats_faces.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <utility>

#include "base/parallel.h"

namespace tetralux {
namespace {

constexpr size_t kCellsAtOnce = 1 << 14;
constexpr size_t kPointsAtOnce = 1 << 12;

template <typename Key>
struct Buckets {
  std::vector<std::uint64_t> ends;  // of each point's keys
  std::vector<Key> keys;

  std::span<Key> of(size_t point) {
    const std::uint64_t begin = point == 0 ? 0 : ends[point - 1];
    return std::span(keys).subspan(begin, ends[point] - begin);
  }
};

// Deals out what forEach(cell, emit) emits: emit(point, key).
// The order within a bucket depends on how threads meet; it is sorted later.
template <typename Key, typename ForEach>
Buckets<Key> dealOut(std::span<const CellVertices> cells, size_t pointCount, const ForEach& forEach) {
  Buckets<Key> buckets;
  buckets.ends.resize(pointCount);
  const auto forAll = [&](const auto& emit) {
    parallelFor(cells.size(), kCellsAtOnce, [&](size_t begin, size_t end, unsigned) {
      for (size_t i = begin; i < end; i++) forEach(sortedVertices(cells[i]), emit);
    });
  };
  const auto counter = [&](std::uint32_t point) { return std::atomic_ref(buckets.ends[point]); };
  forAll([&](std::uint32_t point, const Key&) { counter(point).fetch_add(1, std::memory_order_relaxed); });
  std::uint64_t total = 0;
  for (std::uint64_t& end : buckets.ends) end = std::exchange(total, total + end);
  // Each entry is the beginning of its bucket now, and its end once all keys are there.
  buckets.keys.resize(total);
  forAll([&](std::uint32_t point, const Key& key) {
    buckets.keys[counter(point).fetch_add(1, std::memory_order_relaxed)] = key;
  });
  return buckets;
}

// How many different keys there are, by how often they occur.
struct GroupCounts {
  std::uint64_t once = 0;
  std::uint64_t twice = 0;
  std::uint64_t oftener = 0;
};

template <typename Key>
GroupCounts countGroups(Buckets<Key>& buckets) {
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

CellVertices sortedVertices(CellVertices v) {
  const auto order = [&v](size_t a, size_t b) {
    if (v[b] < v[a]) std::swap(v[a], v[b]);
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  return v;
}

FaceCounts countFaces(std::span<const CellVertices> cells, size_t pointCount) {
  auto buckets = dealOut<std::uint64_t>(cells, pointCount, [](const CellVertices& v, const auto& emit) {
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
  auto buckets = dealOut<Key>(cells, pointCount, [](const CellVertices& v, const auto& emit) {
    emit(v[0], Key{v[1], v[2], v[3]});
  });
  const GroupCounts groups = countGroups(buckets);
  return cells.size() - (groups.once + groups.twice + groups.oftener);
}

}  // namespace tetralux
