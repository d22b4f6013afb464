#include "cli/order_table.h"

#include "base/progress.h"
#include "cli/stats_json.h"

namespace tetralux::cli {

std::vector<OrderRow> orderTable(const gpu::Context& context, const LoadedScene& loaded,
                                 const render::RendererOptions& options, const render::RenderOptions& frameOptions,
                                 std::uint32_t frames) {
  const size_t orders = render::orderNames().size();
  render::RenderOptions timedOptions = frameOptions;
  timedOptions.timed = true;
  std::vector<OrderRow> rows;
  Progress progress("orders", orders);
  for (size_t i = 0; i < orders; i++) {
    render::RendererOptions rowOptions = options;
    rowOptions.order = static_cast<render::Order>(i);
    rowOptions.checkOrder = true;
    render::Renderer renderer(context, loaded.mesh, loaded.field, rowOptions);
    renderer.setTransferFunction(loaded.scene.transferFunction);
    const OrderRow checked{rowOptions.order, renderer.draw(loaded.scene.camera, loaded.scene.size, frameOptions).order};
    rows.push_back(checked);

    // Times are those of a frame that is not asked to count.
    rowOptions.checkOrder = false;
    render::Renderer timed(context, loaded.mesh, loaded.field, rowOptions);
    timed.setTransferFunction(loaded.scene.transferFunction);
    std::vector<render::FrameStats> stats;
    for (std::uint32_t frame = 0; frame <= frames; frame++) {
      render::FrameStats s = timed.draw(loaded.scene.camera, loaded.scene.size, timedOptions);
      if (frame > 0) stats.push_back(std::move(s));  // the first one makes pipelines
    }
    for (const char* pass : {"order", "check", "sort"}) rows.back().orderMs += medianPassMs(stats, pass);
    rows.back().frameMs = medianFrameMs(stats);
    progress.advance();
  }
  return rows;
}

}  // namespace tetralux::cli
