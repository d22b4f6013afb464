// Passes beside the least that they could cost on the device (bench --floor).
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "render/renderer.h"

namespace tetralux::cli {

// What a frame's passes do and the floors under them; docs/benchmarks.md has the keys. Draws frames.
//   frames   the timed ones
nlohmann::ordered_json floorJson(const gpu::Context& context, render::Renderer& renderer, const Camera& camera,
                                 ImageSize size, const render::RenderOptions& options, std::uint64_t cells,
                                 std::uint64_t points, const std::vector<render::FrameStats>& frames);

// The same as a table.
void printFloor(const nlohmann::ordered_json& floor);

}  // namespace tetralux::cli
