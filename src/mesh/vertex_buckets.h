// Faces and cells told apart by their sorted vertices.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "mesh/tet_mesh.h"

namespace tetralux {

// Indices in ascending order. In the header: loops over all cells call nothing else.
inline CellVertices sortedVertices(CellVertices v) {
  const auto order = [&v](size_t a, size_t b) {
    const std::uint32_t low = v[a] < v[b] ? v[a] : v[b];
    v[b] = v[a] < v[b] ? v[b] : v[a];
    v[a] = low;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  return v;
}

inline bool hasRepeatedVertex(const CellVertices& sorted) {
  return sorted[0] == sorted[1] || sorted[1] == sorted[2] || sorted[2] == sorted[3];
}

// Keys dealt out by a vertex (a counting sort). What is left to sort is small: the keys of one vertex.
template <typename Key>
struct VertexBuckets {
  static constexpr size_t kCellsAtOnce = 1 << 14;

  std::vector<std::uint64_t> ends;  // of each point's keys
  std::vector<Key> keys;

  std::span<Key> of(size_t point) {
    const std::uint64_t begin = point == 0 ? 0 : ends[point - 1];
    return std::span(keys).subspan(begin, ends[point] - begin);
  }

  // Deals out what forEach(cell index, emit) emits: emit(point, key). The order within a bucket depends on how threads
  // meet. 8 bytes per point and the keys.
  template <typename ForEach>
  static VertexBuckets dealOut(size_t cellCount, size_t pointCount, const ForEach& forEach) {
    VertexBuckets buckets;
    buckets.ends.resize(pointCount);
    const auto forAll = [&](const auto& emit) {
      parallelFor(cellCount, kCellsAtOnce, [&](size_t begin, size_t end, unsigned) {
        for (size_t i = begin; i < end; i++) forEach(i, emit);
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
};

}  // namespace tetralux
