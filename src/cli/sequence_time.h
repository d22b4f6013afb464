// How fast pictures of a turning camera reach the host.
#pragma once

#include <nlohmann/json.hpp>

#include "render/renderer.h"

namespace tetralux::cli {

// Draws a turn and reads every picture back, by the host's clock: `alone_ms` per frame where each is drawn, waited for
// and read, `in_flight_ms` where the next is begun before (Renderer::begin), as `render --frames` does. Passes are not
// timed meanwhile. Throws like Renderer::draw().
//   frames   at least 1; the camera turns by one degree a frame about its `center`
nlohmann::ordered_json sequenceJson(render::Renderer& renderer, const Camera& camera, ImageSize size,
                                    render::RenderOptions options, std::uint32_t frames);

}  // namespace tetralux::cli
