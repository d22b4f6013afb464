#include "mesh/connected_parts.h"

#include <atomic>
#include <unordered_map>

#include "base/parallel.h"

namespace tetralux {
namespace {

constexpr size_t kCellsAtOnce = 1 << 14;

// Sets of cells that grow together, with the side that each cell has in its set (Anderson and Woll 1991, wait-free
// union-find; the parity is ours). A set's root is its smallest cell, so that nothing hangs on how threads meet.
class SidedSets {
 public:
  // A cell seen from the root of its set.
  struct Place {
    std::uint32_t root;
    std::uint32_t side;  // 0: that of the root
  };

  explicit SidedSets(size_t count) : up_(count) {
    for (std::uint32_t i = 0; i < count; i++) up_[i] = 2 * i;
  }

  Place find(std::uint32_t cell) {
    std::uint32_t side = 0;
    for (;;) {
      const std::uint32_t up = load(cell);
      const std::uint32_t parent = up / 2;
      const std::uint32_t above = load(parent);
      if (above / 2 == parent) return {parent, side ^ (up & 1)};
      // The path is halved. Another thread may have gone further: what it wrote over was no less true.
      const std::uint32_t shorter = above ^ (up & 1);
      std::atomic_ref(up_[cell]).store(shorter, std::memory_order_relaxed);
      side ^= shorter & 1;
      cell = shorter / 2;
    }
  }

  // Joins the sets of two cells. Where they are one already, nothing happens, whatever the sides are.
  void join(std::uint32_t a, std::uint32_t b, bool onOtherSide) {
    for (;;) {
      Place low = find(a);
      Place high = find(b);
      if (low.root == high.root) return;
      if (high.root < low.root) std::swap(low, high);
      std::uint32_t isRoot = 2 * high.root;
      const std::uint32_t up = 2 * low.root + (low.side ^ high.side ^ (onOtherSide ? 1u : 0u));
      if (std::atomic_ref(up_[high.root]).compare_exchange_strong(isRoot, up, std::memory_order_relaxed)) return;
    }
  }

 private:
  std::uint32_t load(std::uint32_t cell) { return std::atomic_ref(up_[cell]).load(std::memory_order_relaxed); }

  std::vector<std::uint32_t> up_;  // 2 x a cell nearer to the root + whether it is on the other side
};

struct Part {
  size_t cells = 0;
  size_t onOtherSide = 0;
};

}  // namespace

std::vector<bool> cellsThatMayOverlap(const Adjacency& adjacency) {
  const size_t count = adjacency.neighbors.size();
  SidedSets sets(count);
  // A part may be folded so that a walk around an edge comes back on the other side. What counts then is which face was
  // joined last, so with folds cells are taken in order.
  const size_t grain = adjacency.foldedFaces == 0 ? kCellsAtOnce : count;
  parallelFor(count, grain, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) {
      const auto cell = static_cast<std::uint32_t>(i);
      for (std::uint32_t k = 0; k < 4; k++) {
        const std::uint32_t neighbor = adjacency.neighbors[cell][k];
        if (neighbor == kNoCell || neighbor > cell) continue;  // each face once
        sets.join(neighbor, cell, (adjacency.sides[cell] >> (4 + k) & 1) != 0);
      }
    }
  });

  std::unordered_map<std::uint32_t, Part> parts;
  Part* part = nullptr;
  std::uint32_t root = kNoCell;
  for (std::uint32_t cell = 0; cell < count; cell++) {
    const SidedSets::Place place = sets.find(cell);
    if (place.root != root) {  // mostly the part of the cell before
      root = place.root;
      part = &parts[root];
    }
    part->cells++;
    part->onOtherSide += place.side;
  }
  if (parts.size() <= 1 && adjacency.foldedFaces == 0) return {};

  std::uint32_t largest = kNoCell;
  for (const auto& [first, candidate] : parts) {
    const size_t most = largest == kNoCell ? 0 : parts[largest].cells;
    if (candidate.cells > most || (candidate.cells == most && first < largest)) largest = first;
  }
  const Part& main = parts[largest];
  const std::uint32_t smallerSide = 2 * main.onOtherSide < main.cells ? 1 : 0;
  std::vector<bool> result(count);
  for (std::uint32_t cell = 0; cell < count; cell++) {
    const SidedSets::Place place = sets.find(cell);
    result[cell] = place.root != largest || (main.onOtherSide > 0 && place.side == smallerSide);
  }
  return result;
}

}  // namespace tetralux
