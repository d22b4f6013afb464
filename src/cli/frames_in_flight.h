// Frames of a sequence, the next begun while the last is taken.
#pragma once

#include <cstdint>
#include <utility>

#include "render/renderer.h"

namespace tetralux::cli {

// Frames that the device may have in hand: it draws one while the host takes the other's picture.
inline constexpr std::size_t kFramesInFlight = 2;

// Draws frames 0 to count - 1 and hands each over in order; timed ones are begun when the last has been taken. Throws
// like Renderer::draw().
//   cameraOf   camera of a frame, by its number
//   take       called with the frame's number and what Renderer::finish() gave
template <typename CameraOf, typename Take>
void drawInFlight(render::Renderer& renderer, std::uint32_t count, ImageSize size, const render::RenderOptions& options,
                  const CameraOf& cameraOf, const Take& take) {
  const std::size_t depth = options.timed ? 1 : kFramesInFlight;
  std::uint32_t begun = 0;
  for (std::uint32_t frame = 0; frame < count; frame++) {
    for (; begun < count && renderer.inFlight() < depth; begun++) renderer.begin(cameraOf(begun), size, options);
    take(frame, renderer.finish());
  }
}

}  // namespace tetralux::cli
