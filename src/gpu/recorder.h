// A frame's commands, pass by pass, timed in the way that is right for the device.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "gpu/commands.h"

namespace tetralux::gpu {

// What it takes to time passes on a device.
enum class PassTiming {
  Off,         // one submission, nothing timed but the whole
  Submits,     // each pass is submitted and waited for by itself: for devices whose timestamps are not to be trusted
  Timestamps,  // one submission with a timestamp before and after each pass
};

// Timestamps on real GPUs; on CPU devices they are written when commands are queued, not when they run.
PassTiming bestTiming(const DeviceInfo& info);

struct PassTime {
  std::string name;
  double gpuMs = 0.0;
};

class Recorder {
 public:
  Recorder(const Context& context, PassTiming timing);

  // Starts a pass; the one before ends here. Names may repeat, their times are added up.
  CommandBuffer& pass(const std::string& name);

  // Ends the last pass, runs what has not run yet and waits: results can be read on the host. Recording may go on.
  void sync();

  // The two halves of sync(): the host may do other things between them, but not record.
  void submit();
  void wait();

  // After sync(): one entry per name in order of first use; empty when timing is off.
  const std::vector<PassTime>& passTimes() const { return times_; }
  // After sync(): what all that was recorded took, ms. The host's work between submissions is left out.
  double totalMs() const { return totalMs_; }

 private:
  void endPass();
  void begin();
  void collectTimestamps();
  void addTime(const std::string& name, double gpuMs);

  const Context& context_;
  PassTiming timing_;
  std::unique_ptr<CommandBuffer> commands_;
  std::string currentPass_;
  std::vector<std::string> stampedPasses_;
  DeviceHandle<VkQueryPool> queries_;
  std::vector<PassTime> times_;
  double totalMs_ = 0.0;
  std::chrono::steady_clock::time_point submitted_;
};

}  // namespace tetralux::gpu
