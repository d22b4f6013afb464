#include "render/warm_pipelines.h"

#include "base/error.h"
#include "mesh/generate.h"

namespace tetralux::render {

std::unique_ptr<MarchPass> warmPipelines(const gpu::Context& context, const RendererOptions& options,
                                         const LikelyFrame& frame) {
  // Methods with tables would build them, and a tolerance depends on the mesh.
  if (projectionFor(options).projection != CellProjection::March || options.tolerance ||
      frame.options.integration != Integration::Exact)
    return nullptr;
  constexpr ImageSize kSize{8, 8};
  const TetMesh mesh = kuhnGrid(1, 1, 1, glm::dvec3(0), glm::dvec3(1), [](const glm::dvec3& p) { return p.z; });
  Camera camera;
  camera.projection = frame.projection;
  camera.eye = {0.5, 0.5, -3};
  camera.center = {0.5, 0.5, 0.5};
  camera.up = {0, 1, 0};
  camera.heightWorld = 2;
  // Most pictures do not need double precision; whether this one does depends on the mesh.
  RendererOptions likely = options;
  likely.doublePrecision = options.doublePrecision.value_or(false);
  try {
    Renderer renderer(context, mesh, scalarField(mesh, "", "warm-up"), likely);
    renderer.setTransferFunction(frame.transferFunction);
    renderer.draw(camera, kSize, frame.options);
    return renderer.takeMarchPass();
  } catch (const Error&) {
    return nullptr;  // the renderer of the mesh will meet it, and name what the user asked for
  }
}

}  // namespace tetralux::render
