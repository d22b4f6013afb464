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

// Device memory of one sort: 16 bytes per cell and the counters.
class SortStorage {
 public:
  SortStorage(const gpu::Context& context, std::uint32_t cellCount, SortVariant variant);

  // Input: the cull pass writes one key per cell here, KEY_CULLED for those that take no part.
  const gpu::Buffer& keys() const { return keys_[0]; }
  // Result, after a sort of `keyBits`: indices of the kept cells by ascending key, equal keys by ascending index.
  const gpu::Buffer& order(std::uint32_t keyBits) const { return values_[resultSide(keyBits)]; }
  const gpu::TexelView& orderView(std::uint32_t keyBits) const { return valueViews_[resultSide(keyBits)]; }
  // Result: how many cells were kept (one uint).
  const gpu::Buffer& kept() const { return kept_; }

  SortVariant variant() const { return variant_; }
  std::uint64_t sizeBytes() const;

 private:
  friend class SortPass;
  static size_t resultSide(std::uint32_t keyBits);

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
  // barrier from compute writes is owed.
  //   keyBits   bits that differ, 1 to 31: one round per 8 bits
  void record(gpu::CommandBuffer& commands, SortStorage& storage, std::uint32_t keyBits, bool wideAddressing);

 private:
  ComputeVariants upsweep_;
  ComputeVariants spine_;
  ComputeVariants bases_;  // tiled variant only
  ComputeVariants downsweep_;
};

}  // namespace tetralux::render
