// Cells drawn as outlines, against the exact picture and against fans.
#include <gtest/gtest.h>

#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"

namespace tetralux::render {
namespace {

using test::GpuTest;
using test::projectedImage;
using test::projectionError;
using test::withProjection;

const RendererOptions kSilhouette = withProjection(CellProjection::Silhouette);

TEST_F(GpuTest, SilhouettesAgreeWithTheReferenceOnHardMeshes) {
  for (const auto& [name, mesh] : test::hardMeshes()) {
    const std::vector<Camera> views = test::orderViews(mesh);
    for (size_t view = 0; view < views.size(); view++) {
      const ImageDifference d = projectionError(context(), mesh, views[view], kSilhouette);
      EXPECT_LE(d.rmse, 5e-5) << name << ", view " << view;
      EXPECT_LE(d.max, 1.0 / 255.0) << name << ", view " << view;
      EXPECT_EQ(d.nonFinite, 0u);
    }
  }
}

TEST_F(GpuTest, SilhouettesOfCellFieldsAndByAddress) {
  TetMesh mesh = kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), waveField);
  std::vector<float> values;
  for (size_t i = 0; i < mesh.cellCount(); i++) values.push_back(static_cast<float>(i * 7919 % 100) / 99.0f);
  mesh.cellArrays.push_back({"c", 1, values});
  for (const Camera& camera : test::orderViews(mesh)) {
    EXPECT_LE(projectionError(context(), mesh, camera, kSilhouette, "c").rmse, 5e-5);
    EXPECT_EQ(projectedImage(context(), mesh, camera, withProjection(CellProjection::Silhouette, true), "c").pixels,
              projectedImage(context(), mesh, camera, kSilhouette, "c").pixels);
  }
}

// Cycles go through the lists of the apart pass.
TEST_F(GpuTest, SilhouettesOfACycleAreCompositedApart) {
  const TetMesh mesh = cyclicOctahedron();
  Camera camera;
  camera.eye = {0.02, 0.03, -5};
  camera.center = {0, 0, 0.5};
  camera.up = {0, 1, 0};
  camera.fovyDegrees = 30;
  EXPECT_LE(projectionError(context(), mesh, camera, kSilhouette).rmse, 5e-5);
}

TEST_F(GpuTest, SilhouettesAreFewerTriangles) {
  const TetMesh mesh = randomDelaunay(1500, 7);
  const Camera camera = test::orderViews(mesh)[0];
  std::uint64_t triangles[2];
  for (const CellProjection projection : {CellProjection::Pt, CellProjection::Silhouette}) {
    Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), withProjection(projection));
    renderer.setTransferFunction(test::orderTransfer());
    const FrameStats stats = renderer.draw(camera, test::kProjectionSize);
    triangles[projection == CellProjection::Pt ? 0 : 1] = stats.triangles;
    EXPECT_LE(stats.triangles, (projection == CellProjection::Pt ? 4 : 2) * stats.drawnCells);
  }
  EXPECT_LT(triangles[1], 0.6 * static_cast<double>(triangles[0]));
}

}  // namespace
}  // namespace tetralux::render
