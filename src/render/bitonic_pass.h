// Pass "sort", another way: a bitonic merge sort of pairs of key and cell.
#pragma once

#include "gpu/commands.h"
#include "render/pipeline_variants.h"
#include "render/sort_pass.h"

namespace tetralux::render {

// Device memory of the sort beside SortStorage: 8 bytes per cell. (The network is one of 2^k places, but what lies
// beyond the last cell is never stored; see include/bitonic.glsl.)
class BitonicStorage {
 public:
  // Throws Error(Device) when there is no memory.
  BitonicStorage(const gpu::Context& context, std::uint32_t cellCount);

  std::uint64_t sizeBytes() const { return pairs_.sizeBytes(); }

 private:
  friend class BitonicPass;
  std::uint32_t cellCount_;
  bool needsWideAddressing_;  // pairs are longer than keys: they may need it where the mesh does not
  gpu::Buffer pairs_;         // key, cell
  gpu::TexelView pairView_;
};

class BitonicPass {
 public:
  // The result is left where a radix sort of these bits leaves it.
  static constexpr SortRange kResult{0, 24};

  explicit BitonicPass(const gpu::Context& context);

  // Records the sort of sort.keys(), whole keys, which stay as they are; those from KEY_TRANSPARENT up take no part.
  // Result: sort.order(kResult) and sort.kept(), the same as the radix sort's. The writer of the keys owes a barrier
  // before; after, a barrier from compute writes is owed. Time grows as n log^2 n.
  //   storage   made for the same number of cells
  void record(gpu::CommandBuffer& commands, const SortStorage& sort, const BitonicStorage& storage,
              bool wideAddressing);

 private:
  ComputeVariants block_;
  ComputeVariants step_;
  ComputeVariants merge_;
  ComputeVariants take_;
};

}  // namespace tetralux::render
