#include "gpu/recorder.h"

#include <algorithm>

#include "base/check.h"

namespace tetralux::gpu {
namespace {

constexpr std::uint32_t kLargestPassCount = 2048;

}  // namespace

PassTiming bestTiming(const DeviceInfo& info) { return info.isCpu ? PassTiming::Submits : PassTiming::Timestamps; }

Recorder::Recorder(const Context& context, PassTiming timing) : context_(context), timing_(timing) {
  if (timing_ == PassTiming::Timestamps) {
    VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = 2 * kLargestPassCount;
    VkQueryPool pool = VK_NULL_HANDLE;
    VK_CHECK(vkCreateQueryPool(context.device(), &info, nullptr, &pool));
    queries_ = {context.device(), pool, vkDestroyQueryPool};
  }
  begin();
}

void Recorder::begin() {
  commands_ = std::make_unique<CommandBuffer>(context_);
  if (timing_ == PassTiming::Timestamps)
    vkCmdResetQueryPool(commands_->get(), queries_.get(), 0, 2 * kLargestPassCount);
}

CommandBuffer& Recorder::pass(const std::string& name) {
  endPass();
  currentPass_ = name;
  if (timing_ == PassTiming::Timestamps) {
    CHECK_LT(stampedPasses_.size(), kLargestPassCount);
    vkCmdWriteTimestamp2(commands_->get(), VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_.get(),
                         static_cast<std::uint32_t>(2 * stampedPasses_.size()));
    stampedPasses_.push_back(name);
  }
  return *commands_;
}

void Recorder::endPass() {
  if (currentPass_.empty()) return;
  if (timing_ == PassTiming::Timestamps) {
    vkCmdWriteTimestamp2(commands_->get(), VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_.get(),
                         static_cast<std::uint32_t>(2 * stampedPasses_.size() - 1));
  } else if (timing_ == PassTiming::Submits) {
    commands_->barrier(access::kAnyWrite, access::kAnyRead | access::kHostRead);
    const double milliseconds = commands_->submitAndWait();
    addTime(currentPass_, milliseconds);
    totalMs_ += milliseconds;
    begin();
  }
  currentPass_.clear();
}

void Recorder::sync() {
  submit();
  wait();
}

void Recorder::submit() {
  endPass();
  if (timing_ == PassTiming::Submits) return;  // every pass has run already
  // Also what keeps the next submission from writing what this one still reads.
  commands_->barrier(access::kAnyWrite, access::kAnyRead | access::kHostRead);
  submitted_ = std::chrono::steady_clock::now();
  commands_->submit();
}

void Recorder::wait() {
  if (timing_ == PassTiming::Submits) return;
  commands_->wait();
  if (timing_ == PassTiming::Timestamps)
    collectTimestamps();
  else
    totalMs_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - submitted_).count();
  begin();
}

void Recorder::collectTimestamps() {
  if (stampedPasses_.empty()) return;
  std::vector<std::uint64_t> ticks(2 * stampedPasses_.size());
  VK_CHECK(vkGetQueryPoolResults(context_.device(), queries_.get(), 0, static_cast<std::uint32_t>(ticks.size()),
                                 ticks.size() * sizeof ticks[0], ticks.data(), sizeof ticks[0],
                                 VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT));
  const double msPerTick = static_cast<double>(context_.timestampPeriodNs()) * 1e-6;
  for (size_t i = 0; i < stampedPasses_.size(); i++)
    addTime(stampedPasses_[i], static_cast<double>(ticks[2 * i + 1] - ticks[2 * i]) * msPerTick);
  totalMs_ += static_cast<double>(ticks.back() - ticks.front()) * msPerTick;
  stampedPasses_.clear();
}

void Recorder::addTime(const std::string& name, double gpuMs) {
  const auto found = std::find_if(times_.begin(), times_.end(), [&](const PassTime& t) { return t.name == name; });
  if (found != times_.end())
    found->gpuMs += gpuMs;
  else
    times_.push_back({name, gpuMs});
}

}  // namespace tetralux::gpu
