// The exact images that come with the shared scenes.
#include <gtest/gtest.h>

#include "image/image_io.h"
#include "image/metrics.h"
#include "mesh/mesh_io.h"
#include "reference/ray_caster.h"
#include "scene/scene_file.h"
#include "support/shared_data.h"

namespace tetralux::reference {
namespace {

class SharedImages : public ::testing::TestWithParam<const char*> {};

TEST_P(SharedImages, AreMetToRounding) {
  const std::string name = GetParam();
  REQUIRE_SHARED("scenes/" + name + ".json");
  REQUIRE_SHARED("reference/" + name + ".exr");
  const Scene scene = readScene(test::sharedPath("scenes/" + name + ".json"));
  const TetMesh mesh = readMesh(scene.meshPath);
  const ScalarField field = scalarField(mesh, scene.fieldName, name);
  const Image image =
      toImage(renderPixels({mesh, field, scene.transferFunction, scene.camera, scene.size}), scene.size);
  const ImageDifference d = compareImages(readExr(test::sharedPath("reference/" + name + ".exr")), image);
  EXPECT_LE(d.rmse, 1e-6);
  EXPECT_LE(d.max, 1e-4);
  EXPECT_EQ(d.nonFinite, 0u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SharedImages,
                         ::testing::Values("spx_smooth", "spx_ortho", "spx_peak", "spx_close", "bluntfin_smooth",
                                           "bluntfin_ortho", "bluntfin_peak", "bluntfin_close", "combustor_smooth",
                                           "combustor_ortho", "combustor_peak", "combustor_close", "oxygenpost_smooth",
                                           "oxygenpost_ortho", "oxygenpost_peak", "oxygenpost_close", "neghip_smooth",
                                           "neghip_ortho", "neghip_peak", "neghip_close"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace tetralux::reference
