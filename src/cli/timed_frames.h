// Frames of a turning camera, timed.
#pragma once

#include <chrono>
#include <vector>

#include "cli/warm_up.h"
#include "render/renderer.h"

namespace tetralux::cli {

struct TimedTurn {
  std::uint32_t warmup = 0;  // frames drawn before, at least
  double warmupMs = 0.0;     // and for how long, see WarmUp
  std::uint32_t frames = 1;  // frames timed; the camera turns by one degree a frame about its `center`
  // No further frame begins after so long, seconds. At least one is timed.
  double limitSeconds = 1e9;
};

// Draws and reads back every frame; frame 0 of the timed ones is the camera itself, and those before are all drawn one
// degree before it. Throws like Renderer::draw().
//   options   `timed` should be set
//   onFrame   called after every timed frame
template <typename OnFrame>
std::vector<render::FrameStats> timeTurn(render::Renderer& renderer, const Camera& camera, ImageSize size,
                                         const render::RenderOptions& options, const TimedTurn& turn,
                                         const OnFrame& onFrame) {
  const auto drawn = [&](double degrees) {
    render::FrameStats stats = renderer.draw(camera.turned(degrees), size, options);
    renderer.readImage(&stats);
    return stats;
  };
  const auto start = std::chrono::steady_clock::now();
  for (WarmUp warmUp(turn.warmup, turn.warmupMs); !warmUp.isOver();) {
    const double frameMs = drawn(-1.0).frameMs;
    warmUp.add(frameMs, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  std::vector<render::FrameStats> timed;
  double ms = 0.0;
  for (std::uint32_t frame = 0; frame < turn.frames; frame++) {
    timed.push_back(drawn(frame));
    onFrame();
    ms += timed.back().frameMs + timed.back().readbackMs;
    if (ms > 1e3 * turn.limitSeconds) break;
  }
  return timed;
}

}  // namespace tetralux::cli
