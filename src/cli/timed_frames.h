// Frames of a turning camera, timed.
#pragma once

#include <vector>

#include "render/renderer.h"

namespace tetralux::cli {

struct TimedTurn {
  std::uint32_t warmup = 0;  // frames drawn before
  std::uint32_t frames = 1;  // frames timed; the camera turns by one degree a frame about its `center`
  // No further frame begins after so long, seconds. At least one is timed.
  double limitSeconds = 1e9;
};

// Draws and reads back every frame; frame 0 of the timed ones is the camera itself. Throws like Renderer::draw().
//   options   `timed` should be set
//   onFrame   called after every frame, warm-up included
template <typename OnFrame>
std::vector<render::FrameStats> timeTurn(render::Renderer& renderer, const Camera& camera, ImageSize size,
                                         const render::RenderOptions& options, const TimedTurn& turn,
                                         const OnFrame& onFrame) {
  std::vector<render::FrameStats> timed;
  double ms = 0.0;
  for (std::uint32_t frame = 0; frame < turn.warmup + turn.frames; frame++) {
    const double degrees = static_cast<double>(frame) - turn.warmup;
    render::FrameStats stats = renderer.draw(camera.turned(degrees), size, options);
    renderer.readImage(&stats);
    onFrame();
    if (frame < turn.warmup) continue;
    ms += stats.frameMs + stats.readbackMs;
    timed.push_back(std::move(stats));
    if (ms > 1e3 * turn.limitSeconds) break;
  }
  return timed;
}

}  // namespace tetralux::cli
