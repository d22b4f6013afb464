#include "order_views.h"

#include "reference/ray_caster.h"

namespace tetralux::test {
namespace {

ScalarField fieldOf(const TetMesh& mesh) { return scalarField(mesh, "", "test"); }

render::RendererOptions withOrder(render::RendererOptions options, render::Order order) {
  options.order = order;
  options.checkOrder = true;
  return options;
}

}  // namespace

std::vector<Camera> orderViews(const TetMesh& mesh) {
  const Bounds bounds = mesh.bounds();
  const double size = bounds.diagonal();
  const glm::dvec3 outside = bounds.center() + size * glm::dvec3(0.9, -1.1, 0.6);
  const glm::dvec3 inside = bounds.center() + 0.07 * (bounds.high - bounds.low);
  std::vector<Camera> views;
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    for (const glm::dvec3& eye : {outside, inside}) {
      Camera camera;
      camera.projection = projection;
      camera.eye = eye;
      camera.center = bounds.center();
      camera.fovyDegrees = eye == inside ? 75.0 : 45.0;
      camera.heightWorld = 0.9 * size;
      views.push_back(camera);
    }
  }
  return views;
}

const TransferFunction& orderTransfer() {
  static const TransferFunction transfer({{0, {0.1, 0.1, 0.8}, 0.1},
                                          {0.3, {0.1, 0.7, 0.2}, 2},
                                          {0.5, {0.9, 0.8, 0.1}, 0},
                                          {0.7, {0.9, 0.3, 0.1}, 6},
                                          {1, {0.8, 0.1, 0.3}, 1}},
                                         "bands");
  return transfer;
}

OrderedRenderer::OrderedRenderer(const gpu::Context& context, const TetMesh& mesh, render::Order order,
                                 render::RendererOptions options)
    : renderer_(context, mesh, fieldOf(mesh), withOrder(options, order)) {
  renderer_.setTransferFunction(orderTransfer());
}

render::OrderReport reportOf(const gpu::Context& context, const TetMesh& mesh, render::Order order,
                             const Camera& camera) {
  return OrderedRenderer(context, mesh, order).draw(camera).order;
}

Image exactImage(const TetMesh& mesh, const TransferFunction& transfer, const Camera& camera) {
  const ScalarField field = fieldOf(mesh);
  return reference::toImage(reference::renderPixels({mesh, field, transfer, camera, kOrderSize}), kOrderSize);
}

}  // namespace tetralux::test
