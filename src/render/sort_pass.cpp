#include "render/sort_pass.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "shared/limits.h"
#include "shared/sort.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

using gpu::access::kComputeReadWrite;
using gpu::access::kComputeWrite;

struct UpsweepPush {
  VkDeviceAddress keys;
  std::uint32_t cellCount;
  std::uint32_t columns;
  std::uint32_t shift;
};

struct DownsweepPush {
  VkDeviceAddress keys;
  VkDeviceAddress values;
  VkDeviceAddress keysOut;
  VkDeviceAddress valuesOut;
  std::uint32_t cellCount;
  std::uint32_t columns;
  std::uint32_t shift;
};

std::uint32_t columnCount(std::uint32_t cellCount, SortVariant variant) {
  const bool isChunks = variant == SortVariant::Chunks;
  const std::uint32_t keys = isChunks ? shared::SORT_LONGEST_CHUNK : shared::SORT_TILE_KEYS;
  const std::uint32_t least = isChunks ? shared::SORT_LEAST_CHUNKS : 1;
  return std::max(least, cellCount / keys + (cellCount % keys != 0 ? 1 : 0));
}

std::string shaderName(SortVariant variant, const char* step) {
  return fmt::format("sort/{}_{}.comp", variant == SortVariant::Chunks ? "chunk" : "tile", step);
}

}  // namespace

std::uint32_t SortRange::rounds() const { return (bitCount + shared::SORT_DIGIT_BITS - 1) / shared::SORT_DIGIT_BITS; }

SortVariant bestSortVariant(const gpu::DeviceInfo& info) {
  return info.isCpu || info.subgroupSize < shared::SORT_TILE_LEAST_SUBGROUP ? SortVariant::Chunks : SortVariant::Tiles;
}

SortStorage::SortStorage(const gpu::Context& context, std::uint32_t cellCount, SortVariant variant)
    : variant_(variant), cellCount_(cellCount), columns_(columnCount(cellCount, variant)) {
  const std::uint64_t bytes = std::uint64_t{4} * cellCount;
  for (size_t side = 0; side < 2; side++) {
    keys_[side] = gpu::Buffer(context, bytes, gpu::MemoryKind::Device, "sort keys");
    values_[side] = gpu::Buffer(context, bytes, gpu::MemoryKind::Device, "sort values");
    keyViews_[side] = gpu::TexelView(context, keys_[side], VK_FORMAT_R32_UINT);
    valueViews_[side] = gpu::TexelView(context, values_[side], VK_FORMAT_R32_UINT);
  }
  counts_ =
      gpu::Buffer(context, std::uint64_t{4} * shared::SORT_DIGITS * columns_, gpu::MemoryKind::Device, "sort counts");
  totals_ = gpu::Buffer(context, std::uint64_t{4} * shared::SORT_DIGITS, gpu::MemoryKind::Device, "sort totals");
  kept_ = gpu::Buffer(context, 4, gpu::MemoryKind::Device, "sort kept");
}

std::uint64_t SortStorage::sizeBytes() const {
  std::uint64_t bytes = counts_.sizeBytes() + totals_.sizeBytes() + kept_.sizeBytes();
  for (size_t side = 0; side < 2; side++) bytes += keys_[side].sizeBytes() + values_[side].sizeBytes();
  return bytes;
}

SortPass::SortPass(const gpu::Context& context, SortVariant variant)
    : upsweep_(context, shaderName(variant, "upsweep")),
      spine_(context, shaderName(variant, "spine")),
      bases_(context, "sort/tile_bases.comp"),
      downsweep_(context, shaderName(variant, "downsweep")) {}

void SortPass::record(gpu::CommandBuffer& commands, SortStorage& s, SortRange range, bool wideAddressing) {
  CHECK(range.bitCount >= 1 && range.firstBit + range.bitCount <= 32);
  // Invocations of a column: a tile is a workgroup, a chunk is an invocation.
  const std::uint64_t threads =
      s.variant_ == SortVariant::Tiles ? std::uint64_t{s.columns_} * shared::SORT_TILE_THREADS : s.columns_;
  for (std::uint32_t round = 0; round < range.rounds(); round++) {
    const size_t in = round % 2;
    const size_t out = 1 - in;
    const std::uint32_t shift = range.firstBit + round * shared::SORT_DIGIT_BITS;
    const gpu::SpecConstants constants = {{SPEC_WIDE_ADDRESSING, wideAddressing}, {SPEC_FIRST_DIGIT, round == 0}};
    if (round > 0) commands.barrier(kComputeWrite, kComputeReadWrite);

    // count the digits of every column
    const UpsweepPush upsweepPush{s.keys_[in].address(), s.cellCount_, s.columns_, shift};
    commands.dispatch(upsweep_.get(constants), {s.keyViews_[in], s.counts_, s.kept_}, upsweepPush, threads);
    commands.barrier(kComputeWrite, kComputeReadWrite);

    // beginnings of the digits and of the columns in them; in the first round also how many keys take part
    if (s.variant_ == SortVariant::Chunks) {
      commands.dispatch(spine_.get({}), {s.counts_, s.totals_, s.kept_}, s.columns_, shared::SORT_DIGITS);
    } else {
      const gpu::ComputePipeline& spine = spine_.get({});
      commands.dispatch(spine, {s.counts_, s.totals_}, s.columns_,
                        std::uint64_t{shared::SORT_DIGITS} * spine.workgroupSize());
      commands.barrier(kComputeWrite, kComputeReadWrite);
      commands.dispatch(bases_.get({}), {s.totals_, s.kept_}, gpu::NoPush{}, 1);
    }
    commands.barrier(kComputeWrite, kComputeReadWrite);

    // move keys and values
    const DownsweepPush downsweepPush{s.keys_[in].address(),
                                      s.values_[in].address(),
                                      s.keys_[out].address(),
                                      s.values_[out].address(),
                                      s.cellCount_,
                                      s.columns_,
                                      shift};
    commands.dispatch(downsweep_.get(constants),
                      {s.keyViews_[in], s.valueViews_[in], s.counts_, s.totals_, s.kept_, s.keys_[out], s.values_[out]},
                      downsweepPush, threads);
  }
}

}  // namespace tetralux::render
