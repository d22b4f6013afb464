// Pictures of the shared scenes, as they are drawn by default, against their exact images.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gpu_fixture.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "mesh/mesh_io.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "support/shared_data.h"

namespace tetralux::render {
namespace {

// Draws a scene and compares it with its exact image.
void expectExact(const gpu::Context& context, const std::string& name, const RendererOptions& options) {
  const Scene scene = readScene(test::sharedPath("scenes/" + name + ".json"));
  const TetMesh mesh = readMesh(scene.meshPath);
  Renderer renderer(context, mesh, scalarField(mesh, scene.fieldName, name), options);
  renderer.setTransferFunction(scene.transferFunction);
  renderer.draw(scene.camera, scene.size);
  const ImageDifference d =
      compareImages(readExr(test::sharedPath("reference/" + name + ".exr")), renderer.readImage());
  EXPECT_LE(d.rmse, 5e-5);
  EXPECT_LE(d.max, 1.0 / 255.0);
  EXPECT_EQ(d.nonFinite, 0u);
}

class SharedScenes : public test::GpuTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(SharedScenes, AreDrawnWithinTheirLimit) {
  const std::string name = GetParam();
  REQUIRE_SHARED("scenes/" + name + ".json");
  REQUIRE_SHARED("reference/" + name + ".exr");
  expectExact(context(), name, {});
}

TEST_P(SharedScenes, AreMarchedWithinTheirLimit) {
  const std::string name = GetParam();
  REQUIRE_SHARED("scenes/" + name + ".json");
  REQUIRE_SHARED("reference/" + name + ".exr");
  RendererOptions options;
  options.projection = CellProjection::March;
  expectExact(context(), name, options);
}

TEST_P(SharedScenes, AreDrawnAsSilhouettesWithinTheirLimit) {
  const std::string name = GetParam();
  REQUIRE_SHARED("scenes/" + name + ".json");
  REQUIRE_SHARED("reference/" + name + ".exr");
  RendererOptions options;
  options.projection = CellProjection::Silhouette;
  expectExact(context(), name, options);
}

// Small pictures in the quickest order: whether every method copes with the scene's cells, not how well.
TEST_P(SharedScenes, AreDrawnByEveryMethodWithoutANonFiniteValue) {
  const std::string name = GetParam();
  REQUIRE_SHARED("scenes/" + name + ".json");
  const Scene scene = readScene(test::sharedPath("scenes/" + name + ".json"));
  const TetMesh mesh = readMesh(scene.meshPath);
  RendererOptions rendererOptions;
  rendererOptions.order = Order::Radix;
  Renderer renderer(context(), mesh, scalarField(mesh, scene.fieldName, name), rendererOptions);
  renderer.setTransferFunction(scene.transferFunction);
  for (const std::string& method : integrationNames()) {
    for (const Interpolation interpolation : {Interpolation::Perspective, Interpolation::Screen}) {
      RenderOptions options;
      options.integration = parseIntegration(method);
      options.interpolation = interpolation;
      // What is interpolated does not depend on the method, but for colours at vertices.
      if (interpolation == Interpolation::Screen && method != "average" && method != "vertex") continue;
      renderer.draw(scene.camera, {96, 96}, options);
      const Image image = renderer.readImage();
      float largest = 0.0f;
      for (const glm::vec4& pixel : image.pixels) {
        ASSERT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z + pixel.w)) << method;
        ASSERT_GE(std::min({pixel.x, pixel.y, pixel.z, pixel.w}), 0.0f) << method;
        ASSERT_LE(pixel.w, 1.0f + 1e-6f) << method;
        largest = std::max(largest, pixel.w);
      }
      EXPECT_GT(largest, 0.01f) << method;
    }
  }
}

// What differs from fans of pt is where they are projected: a view of each mesh, the hardest.
class CloseScenes : public test::GpuTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(CloseScenes, AreProjectedByVertexShadersWithinTheirLimit) {
  const std::string name = GetParam();
  REQUIRE_SHARED("scenes/" + name + ".json");
  REQUIRE_SHARED("reference/" + name + ".exr");
  RendererOptions options;
  options.projection = CellProjection::Gator;
  expectExact(context(), name, options);
}

INSTANTIATE_TEST_SUITE_P(Scenes, CloseScenes,
                         ::testing::Values("spx_close", "bluntfin_close", "combustor_close", "oxygenpost_close",
                                           "neghip_close"),
                         [](const auto& scene) { return std::string(scene.param); });

INSTANTIATE_TEST_SUITE_P(Scenes, SharedScenes,
                         ::testing::Values("spx_smooth", "spx_ortho", "spx_peak", "spx_close", "bluntfin_smooth",
                                           "bluntfin_ortho", "bluntfin_peak", "bluntfin_close", "combustor_smooth",
                                           "combustor_ortho", "combustor_peak", "combustor_close", "oxygenpost_smooth",
                                           "oxygenpost_ortho", "oxygenpost_peak", "oxygenpost_close", "neghip_smooth",
                                           "neghip_ortho", "neghip_peak", "neghip_close"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace tetralux::render
