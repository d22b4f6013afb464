// Pipelines made while a mesh is read.
#pragma once

#include <memory>

#include "render/renderer.h"

namespace tetralux::render {

// What of a scene is known before its mesh. A wrong guess costs pipelines that nobody uses.
struct LikelyFrame {
  Projection projection = Projection::Perspective;
  TransferFunction transferFunction;
  RenderOptions options;
};

// Draws a small picture of a few cells as a renderer with these options would, so that what drivers compile, some of
// them not before it runs, is compiled. Returns the passes, for Renderer's constructor; null where they depend on more, or
// where the device has no room even for this. The context must not be used meanwhile.
std::unique_ptr<MarchPass> warmPipelines(const gpu::Context& context, const RendererOptions& options,
                                         const LikelyFrame& frame);

}  // namespace tetralux::render
