#include "cli/sequence_time.h"

#include <chrono>

#include "cli/frames_in_flight.h"

namespace tetralux::cli {
namespace {

template <typename Draw>
double msPerFrame(std::uint32_t frames, const Draw& draw) {
  const auto start = std::chrono::steady_clock::now();
  draw();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() / frames;
}

}  // namespace

nlohmann::ordered_json sequenceJson(render::Renderer& renderer, const Camera& camera, ImageSize size,
                                    render::RenderOptions options, std::uint32_t frames) {
  options.timed = false;
  const auto alone = [&] {
    for (std::uint32_t i = 0; i < frames; i++) {
      renderer.draw(camera.turned(i), size, options);
      renderer.readImage();
    }
  };
  const auto inFlight = [&] {
    drawInFlight(
        renderer, frames, size, options, [&](std::uint32_t frame) { return camera.turned(frame); },
        [](std::uint32_t, const render::Renderer::Finished&) {});
  };
  alone();  // lists have grown, clocks are up, the memory of pictures has been touched
  inFlight();
  const double aloneMs = msPerFrame(frames, alone);
  const double inFlightMs = msPerFrame(frames, inFlight);
  return {{"frames", frames}, {"alone_ms", aloneMs}, {"in_flight_ms", inFlightMs}};
}

}  // namespace tetralux::cli
