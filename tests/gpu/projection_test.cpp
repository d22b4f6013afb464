// What every projection has to draw, against the exact pictures. Fans, the default, have order_test.cpp and
// renderer_test.cpp, too.
#include <gtest/gtest.h>

#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"

namespace tetralux::render {
namespace {

using test::projectedImage;
using test::projectionError;
using test::withProjection;

class Projections : public test::GpuTest, public testing::WithParamInterface<std::string> {
 protected:
  RendererOptions options(bool wideAddressing = false) const {
    return withProjection(parseProjection(GetParam()), wideAddressing);
  }
};

TEST_P(Projections, AgreeWithTheReferenceOnHardMeshes) {
  for (const auto& [name, mesh] : test::hardMeshes()) {
    const std::vector<Camera> views = test::orderViews(mesh);
    for (size_t view = 0; view < views.size(); view++) {
      const ImageDifference d = projectionError(context(), mesh, views[view], options());
      EXPECT_LE(d.rmse, 5e-5) << name << ", view " << view;
      EXPECT_LE(d.max, 1.0 / 255.0) << name << ", view " << view;
      EXPECT_EQ(d.nonFinite, 0u);
    }
  }
}

TEST_P(Projections, DrawCellFieldsAndByAddress) {
  TetMesh mesh = kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), waveField);
  std::vector<float> values;
  for (size_t i = 0; i < mesh.cellCount(); i++) values.push_back(static_cast<float>(i * 7919 % 100) / 99.0f);
  mesh.cellArrays.push_back({"c", 1, values});
  for (const Camera& camera : test::orderViews(mesh)) {
    EXPECT_LE(projectionError(context(), mesh, camera, options(), "c").rmse, 5e-5);
    EXPECT_EQ(projectedImage(context(), mesh, camera, options(/*wideAddressing=*/true), "c").pixels,
              projectedImage(context(), mesh, camera, options(), "c").pixels);
  }
}

// Cells that are sorted go through the lists of the apart pass here.
TEST_P(Projections, DrawACycle) {
  const TetMesh mesh = cyclicOctahedron();
  Camera camera;
  camera.eye = {0.02, 0.03, -5};
  camera.center = {0, 0, 0.5};
  camera.up = {0, 1, 0};
  camera.fovyDegrees = 30;
  EXPECT_LE(projectionError(context(), mesh, camera, options()).rmse, 5e-5);
}

INSTANTIATE_TEST_SUITE_P(All, Projections, testing::ValuesIn(projectionNames()),
                         [](const auto& projection) { return projection.param; });

}  // namespace
}  // namespace tetralux::render
