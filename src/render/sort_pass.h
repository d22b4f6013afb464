// Pass "sort": a stable radix sort of the cells by their keys, on the device.
#pragma once

#include "gpu/commands.h"
#include "render/pipeline_variants.h"

namespace tetralux::render {

// How the sort divides its work. Both give the same result.
enum class SortVariant {
  Tiles,   // workgroups rank tiles with subgroup operations: for GPUs
  Chunks,  // each invocation sorts a long run by itself: for processors, or subgroups of fewer than 8 lanes
};

SortVariant bestSortVariant(const gpu::DeviceInfo& info);

// Bits of a key that a sort looks at.
struct SortRange {
  std::uint32_t firstBit = 0;
  std::uint32_t bitCount = 0;  // 1 to 31; one round per 8 bits

  std::uint32_t rounds() const;
};

// Device memory of one sort: 16 bytes per cell and the counters.
class SortStorage {
 public:
  SortStorage(const gpu::Context& context, std::uint32_t cellCount, SortVariant variant);

  // Input: the cull pass writes one key per cell here; those from KEY_TRANSPARENT up take no part.
  const gpu::Buffer& keys() const { return keys_[0]; }
  const gpu::TexelView& keyView() const { return keyViews_[0]; }
  // Result of a sort: indices of the kept cells by ascending key, equal keys by ascending index; and their keys.
  const gpu::Buffer& order(SortRange range) const { return values_[range.rounds() % 2]; }
  const gpu::TexelView& orderView(SortRange range) const { return valueViews_[range.rounds() % 2]; }
  const gpu::TexelView& sortedKeyView(SortRange range) const { return keyViews_[range.rounds() % 2]; }
  // Result: how many cells were kept (one uint).
  const gpu::Buffer& kept() const { return kept_; }

  SortVariant variant() const { return variant_; }
  std::uint64_t sizeBytes() const;

 private:
  friend class SortPass;
  SortVariant variant_;
  std::uint32_t cellCount_;
  std::uint32_t columns_;  // tiles or chunks
  gpu::Buffer keys_[2];
  gpu::Buffer values_[2];
  gpu::TexelView keyViews_[2];
  gpu::TexelView valueViews_[2];
  gpu::Buffer counts_;
  gpu::Buffer totals_;
  gpu::Buffer kept_;
};

class SortPass {
 public:
  SortPass(const gpu::Context& context, SortVariant variant);

  // Records the sort of storage.keys(). The keys are destroyed. The writer of the keys owes a barrier before; after, a
  // barrier from compute writes is owed. Rounds look at whole digits of 8 bits.
  void record(gpu::CommandBuffer& commands, SortStorage& storage, SortRange range, bool wideAddressing);

 private:
  ComputeVariants upsweep_;
  ComputeVariants spine_;
  ComputeVariants bases_;  // tiled variant only
  ComputeVariants downsweep_;
};

}  // namespace tetralux::render
