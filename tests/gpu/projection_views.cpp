#include "projection_views.h"

#include "mesh/generate.h"
#include "order_views.h"
#include "reference/ray_caster.h"
#include "support/tilted.h"

namespace tetralux::test {

render::RendererOptions withProjection(render::CellProjection projection, bool wideAddressing) {
  render::RendererOptions options;
  options.projection = projection;
  options.forceWideAddressing = wideAddressing;
  return options;
}

Image projectedImage(const gpu::Context& context, const TetMesh& mesh, const Camera& camera,
                     const render::RendererOptions& options, const std::string& field, ImageSize size) {
  render::Renderer renderer(context, mesh, scalarField(mesh, field, "test"), options);
  renderer.setTransferFunction(orderTransfer());
  renderer.draw(camera, size);
  return renderer.readImage();
}

ImageDifference projectionError(const gpu::Context& context, const TetMesh& mesh, const Camera& camera,
                                const render::RendererOptions& options, const std::string& field, ImageSize size) {
  const ScalarField values = scalarField(mesh, field, "test");
  const Image exact = reference::toImage(reference::renderPixels({mesh, values, orderTransfer(), camera, size}), size);
  return compareImages(exact, projectedImage(context, mesh, camera, options, field, size));
}

std::vector<NamedMesh> hardMeshes() {
  TetMesh single;
  single.points = std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  single.cells = {{0, 1, 2, 3}};
  single.pointArrays.push_back({"s", 1, std::vector<float>{0, 1, 0.5f, 0.25f}});
  TetMesh inverted = single;
  std::swap(inverted.cells[0][1], inverted.cells[0][2]);

  // Not convex, with holes: a grid without a third of its cells.
  TetMesh holes = kuhnGrid(6, 5, 4, glm::dvec3(0), glm::dvec3(1), waveField);
  std::vector<CellVertices> kept;
  for (size_t i = 0; i < holes.cells.size(); i++) {
    if (i * 2654435761u % 3 != 0) kept.push_back(holes.cells[i]);
  }
  holes.cells = kept;

  return {{"single", single},
          {"inverted", inverted},
          {"grid", kuhnGrid(6, 5, 4, glm::dvec3(0), glm::dvec3(1), waveField)},
          {"jittered", jitteredGrid(5, 5, 5, glm::dvec3(0), glm::dvec3(1), 0.2, 3, waveField)},
          {"holes", holes},
          {"delaunay", randomDelaunay(1500, 7)},
          {"flattened", flattenedDelaunay(800, 3, 0.01)},
          {"twisted", twistedDelaunay(800, 1, 0.0)},
          {"graded", gradedBox(6, 1e3)},
          {"graded and tilted", tilted(gradedBox(6, 1e5))},
          {"slivers", sliverChain(12, 0.7)},
          {"triple", cyclicTriple()},
          {"octahedron", cyclicOctahedron()}};
}

}  // namespace tetralux::test
