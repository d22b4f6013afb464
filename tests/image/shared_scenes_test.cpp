// Default pictures of the shared scenes against their exact images.
#include <gtest/gtest.h>

#include <ostream>

#include "gpu_fixture.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "mesh/mesh_io.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "support/shared_data.h"

namespace tetralux::render {
namespace {

struct SceneLimit {
  const char* name;
  double rmse;  // with the order by centroids

  friend std::ostream& operator<<(std::ostream& out, const SceneLimit& limit) { return out << limit.name; }
};

class SharedScenes : public test::GpuTest, public ::testing::WithParamInterface<SceneLimit> {};

TEST_P(SharedScenes, AreDrawnWithinTheirLimit) {
  const std::string name = GetParam().name;
  REQUIRE_SHARED("scenes/" + name + ".json");
  const Scene scene = readScene(test::sharedPath("scenes/" + name + ".json"));
  const TetMesh mesh = readMesh(scene.meshPath);
  Renderer renderer(context(), mesh, scalarField(mesh, scene.fieldName, name));
  renderer.setTransferFunction(scene.transferFunction);
  renderer.draw(scene.camera, scene.size);
  const ImageDifference d =
      compareImages(readExr(test::sharedPath("reference/" + name + ".exr")), renderer.readImage());
  EXPECT_LE(d.rmse, GetParam().rmse);
  EXPECT_EQ(d.nonFinite, 0u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SharedScenes,
                         ::testing::Values(SceneLimit{"spx_smooth", 2.5e-4}, SceneLimit{"spx_ortho", 2.5e-4},
                                           SceneLimit{"spx_peak", 5e-3}, SceneLimit{"spx_close", 5e-3},
                                           SceneLimit{"bluntfin_smooth", 2.5e-4}, SceneLimit{"bluntfin_ortho", 2.5e-4},
                                           SceneLimit{"bluntfin_peak", 2e-4}, SceneLimit{"bluntfin_close", 5e-3},
                                           SceneLimit{"combustor_smooth", 2.5e-4},
                                           SceneLimit{"combustor_ortho", 2.5e-4}, SceneLimit{"combustor_peak", 5e-4},
                                           SceneLimit{"combustor_close", 5e-3}, SceneLimit{"oxygenpost_smooth", 1e-3},
                                           SceneLimit{"oxygenpost_ortho", 1e-3}, SceneLimit{"oxygenpost_peak", 2e-2},
                                           SceneLimit{"oxygenpost_close", 5e-3}, SceneLimit{"neghip_smooth", 2.5e-4},
                                           SceneLimit{"neghip_ortho", 2.5e-4}, SceneLimit{"neghip_peak", 2e-4},
                                           SceneLimit{"neghip_close", 5e-3}),
                         [](const auto& scene) { return std::string(scene.param.name); });

}  // namespace
}  // namespace tetralux::render
