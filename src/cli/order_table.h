// What every order makes of a view.
#pragma once

#include <vector>

#include "cli/load_scene.h"
#include "render/renderer.h"

namespace tetralux::cli {

struct OrderRow {
  render::Order asked = render::Order::Auto;
  render::OrderReport report;
  double orderMs = 0.0;  // finding, checking and sorting: what differs between orders before cells are drawn
  double frameMs = 0.0;
};

// Draws a scene's view in every order and counts what each gets wrong. Shows progress. Throws Error(Device).
//   frames   of which the medians are taken
std::vector<OrderRow> orderTable(const gpu::Context& context, const LoadedScene& loaded,
                                 const render::RendererOptions& options, const render::RenderOptions& frameOptions,
                                 std::uint32_t frames);

}  // namespace tetralux::cli
