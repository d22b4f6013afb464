#include "render/bitonic_pass.h"

#include <algorithm>

#include "shared/bitonic.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

using namespace gpu::access;

struct BlockPush {
  VkDeviceAddress keys;
  VkDeviceAddress pairs;
  std::uint32_t cellCount;
};

struct StepPush {
  VkDeviceAddress pairs;
  std::uint32_t cellCount;
  std::uint32_t stride;
  std::uint32_t isMirrored;
};

struct MergePush {
  VkDeviceAddress pairs;
  std::uint32_t cellCount;
};

struct TakePush {
  VkDeviceAddress pairs;
  VkDeviceAddress order;
  std::uint32_t cellCount;
};

constexpr std::uint64_t kPairBytes = 8;

// Exchanges over a stride whose lower place holds a cell; exchanges are numbered by it.
std::uint64_t exchangeCount(std::uint64_t cellCount, std::uint64_t stride) {
  return cellCount / (2 * stride) * stride + std::min(cellCount % (2 * stride), stride);
}

}  // namespace

BitonicStorage::BitonicStorage(const gpu::Context& context, std::uint32_t cellCount)
    : cellCount_(cellCount),
      needsWideAddressing_(cellCount > context.info().largestTexelBuffer ||
                           kPairBytes * cellCount > context.info().largestStorageRangeBytes),
      pairs_(context, kPairBytes * std::max(cellCount, 1u), gpu::MemoryKind::Device, "bitonic pairs"),
      pairView_(context, pairs_, VK_FORMAT_R32G32_UINT) {}

BitonicPass::BitonicPass(const gpu::Context& context)
    : block_(context, "sort/bitonic_block.comp"),
      step_(context, "sort/bitonic_step.comp"),
      merge_(context, "sort/bitonic_merge.comp"),
      take_(context, "sort/bitonic_take.comp") {}

void BitonicPass::record(gpu::CommandBuffer& commands, const SortStorage& sort, const BitonicStorage& s,
                         bool wideAddressing) {
  const gpu::SpecConstants constants = {{SPEC_WIDE_ADDRESSING, wideAddressing || s.needsWideAddressing_}};
  const std::uint64_t cellCount = s.cellCount_;
  const VkDeviceAddress pairs = s.pairs_.address();
  const std::uint64_t blocks = (cellCount + shared::BITONIC_BLOCK - 1) / shared::BITONIC_BLOCK;
  const std::uint64_t blockThreads = blocks * shared::BITONIC_THREADS;

  commands.fill(sort.kept(), 0);
  commands.barrier(kTransferWrite, kComputeReadWrite);
  if (cellCount == 0) return;

  // the levels that stay within a block
  commands.dispatch(block_.get(constants), {sort.keyView(), s.pairs_, sort.kept()},
                    BlockPush{sort.keys().address(), pairs, s.cellCount_}, blockThreads);
  commands.barrier(kComputeWrite, kComputeReadWrite);

  // the other levels: strides that are too long for a block one by one, then the rest
  for (std::uint64_t run = shared::BITONIC_BLOCK; run < cellCount; run *= 2) {
    for (std::uint64_t stride = run; stride >= shared::BITONIC_BLOCK; stride /= 2) {
      const StepPush push{pairs, s.cellCount_, static_cast<std::uint32_t>(stride), stride == run};
      commands.dispatch(step_.get(constants), {s.pairView_, s.pairs_}, push, exchangeCount(cellCount, stride));
      commands.barrier(kComputeWrite, kComputeReadWrite);
    }
    commands.dispatch(merge_.get(constants), {s.pairView_, s.pairs_}, MergePush{pairs, s.cellCount_}, blockThreads);
    commands.barrier(kComputeWrite, kComputeReadWrite);
  }

  const gpu::Buffer& order = sort.order(kResult);
  commands.dispatch(take_.get(constants), {s.pairView_, order}, TakePush{pairs, order.address(), s.cellCount_},
                    cellCount);
}

}  // namespace tetralux::render
