// Rays whose work is shared out as GPUs like it (turns in which they come back into the mesh while others of their
// subgroup still walk, several invocations to a job): the same pictures, bit by bit, as on processors.
#include <gtest/gtest.h>

#include <algorithm>

#include "appearance_views.h"
#include "fields/appearance_data.h"
#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"

namespace tetralux::render {
namespace {

using test::GpuTest;

class PairOfRenderers {
 public:
  PairOfRenderers(const gpu::Context& context, const TetMesh& mesh, RendererOptions options = {})
      : field_(scalarField(mesh, "", "test")),
        plain_(context, mesh, field_, withRays(options, false)),
        gpu_(context, mesh, field_, withRays(options, true)) {
    for (Renderer* renderer : {&plain_, &gpu_}) renderer->setTransferFunction(test::orderTransfer());
  }

  void setTransferFunction(const TransferFunction& transfer) {
    for (Renderer* renderer : {&plain_, &gpu_}) renderer->setTransferFunction(transfer);
  }

  void setAppearance(const Appearance& appearance, const TetMesh& mesh) {
    const AppearanceData data = makeAppearanceData(appearance, mesh, field_, "test");
    for (Renderer* renderer : {&plain_, &gpu_}) renderer->setAppearance(appearance, data);
  }

  void expectTheSame(const Camera& camera, ImageSize size = test::kOrderSize, const RenderOptions& options = {}) {
    plain_.draw(camera, size, options);
    gpu_.draw(camera, size, options);
    const Image expected = plain_.readImage();
    EXPECT_TRUE(expected.pixels == gpu_.readImage().pixels);
    EXPECT_TRUE(std::any_of(expected.pixels.begin(), expected.pixels.end(),
                            [](const glm::vec4& pixel) { return pixel.a > 0.0f; }));
  }

 private:
  static RendererOptions withRays(RendererOptions options, bool isGpu) {
    options.projection = CellProjection::March;
    options.gpuRays = isGpu;
    return options;
  }

  ScalarField field_;
  Renderer plain_;
  Renderer gpu_;
};

TEST_F(GpuTest, GpuRaysDrawTheSame) {
  std::vector<test::NamedMesh> meshes = test::hardMeshes();
  meshes.push_back({"twisted", twistedDelaunay(800, 1, 1.5)});
  for (const auto& [name, mesh] : meshes) {
    SCOPED_TRACE(name);
    PairOfRenderers pair(context(), mesh);
    for (const Camera& camera : test::orderViews(mesh)) pair.expectTheSame(camera);
  }
}

TEST_F(GpuTest, GpuRaysDrawTheSameOfEveryKind) {
  const TetMesh mesh = twistedDelaunay(800, 1, 0.7);
  RendererOptions options;
  options.skipEmptySpace = true;
  PairOfRenderers pair(context(), mesh, options);
  const std::vector<Camera> views = test::orderViews(mesh);
  for (const Camera& camera : views) pair.expectTheSame(camera);
  RenderOptions method;
  method.integration = Integration::Average;
  pair.expectTheSame(views[0], test::kOrderSize, method);
  const TransferFunction glow({{0.0, {1, 0.2, 0}, 0.1}, {1.0, {0, 0.3, 1}, 0.6}}, "glow", Emission::PerLength);
  pair.setTransferFunction(glow);
  pair.expectTheSame(views[0]);
  Appearance appearance;
  appearance.lighting = test::sideLight();
  appearance.isosurfaces = {test::surfaceAt(0.3, 0.5), test::surfaceAt(0.6, 0.8)};
  pair.setAppearance(appearance, mesh);
  for (const Camera& camera : views) pair.expectTheSame(camera);
}

// Rays of more cells than a dispatch walks through.
TEST_F(GpuTest, GpuRaysGoOnInAnotherDispatch) {
  const TetMesh mesh = kuhnGrid(1, 1, 8000, glm::dvec3(0), glm::dvec3(1), [](const glm::dvec3&) { return 0.05; });
  Camera camera;
  camera.projection = Projection::Orthographic;
  camera.eye = {0.43, 0.47, -2};
  camera.center = {0.43, 0.47, 0};
  camera.up = {0, 1, 0};
  camera.heightWorld = 0.5;
  PairOfRenderers pair(context(), mesh);
  pair.expectTheSame(camera, {16, 12});
  Appearance appearance;
  appearance.clip = {{{0, 0, 1}, 0.01}};
  pair.setAppearance(appearance, mesh);
  pair.expectTheSame(camera, {16, 12});
}

}  // namespace
}  // namespace tetralux::render
