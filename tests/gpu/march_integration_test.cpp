// Every method of integration along rays that walk: the same segments as outlines have, by the same functions.
#include <gtest/gtest.h>

#include <cmath>

#include "gpu_fixture.h"
#include "image/metrics.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"

namespace tetralux::render {
namespace {

using test::GpuTest;
using test::orderTransfer;
using test::withProjection;

Image drawn(Renderer& renderer, const Camera& camera, Integration integration, bool forceFetch = false,
            ImageSize size = {64, 48}) {
  RenderOptions options;
  options.integration = integration;
  options.table.size = {64, 0, 16};
  options.table.forceFetch = forceFetch;
  EXPECT_EQ(renderer.draw(camera, size, options).integration, integration);
  return renderer.readImage();
}

// By perspective from within, and orthographically from outside. What differs is the rounding of the segments' ends: of
// a scalar by some 1e-6 of its range, which the steepest ramp of the transfer function takes to 1e-4 of an extinction,
// and a silhouette's border.
TEST_F(GpuTest, MarchIntegratesAsSilhouettesDo) {
  const TetMesh mesh = randomDelaunay(600, 5);
  const ScalarField field = scalarField(mesh, "", "test");
  Renderer march(context(), mesh, field, withProjection(CellProjection::March));
  Renderer silhouette(context(), mesh, field, withProjection(CellProjection::Silhouette));
  const std::vector<Camera> views = test::orderViews(mesh);
  for (const Emission emission : {Emission::PerExtinction, Emission::PerLength}) {
    const TransferFunction transfer(orderTransfer().points(), "bands", emission);
    march.setTransferFunction(transfer);
    silhouette.setTransferFunction(transfer);
    for (const std::string& name : integrationNames()) {
      const Integration method = parseIntegration(name);
      if (emission == Emission::PerLength && !carriesEmissionPerLength(method)) continue;
      for (const size_t view : {1, 2}) {
        if (emission == Emission::PerLength && view == 2) continue;
        const ImageDifference d =
            compareImages(drawn(silhouette, views[view], method), drawn(march, views[view], method));
        EXPECT_LE(d.rmse, 2e-5) << name << ", view " << view << ", emission " << static_cast<int>(emission);
        EXPECT_LE(d.max, 1.0 / 255.0) << name << ", view " << view;
        EXPECT_EQ(d.nonFinite, 0u);
      }
    }
  }
}

// Tables are read through bindings of the march's own.
TEST_F(GpuTest, MarchInterpolatesTablesAlikeByShaderAndSampler) {
  const TetMesh mesh = randomDelaunay(300, 5);
  Renderer march(context(), mesh, scalarField(mesh, "", "test"), withProjection(CellProjection::March));
  march.setTransferFunction(orderTransfer());
  const Camera camera = test::orderViews(mesh)[0];
  for (const Integration method : {Integration::Ppi, Integration::Opacity2d, Integration::Preint2d,
                                   Integration::Preint3d, Integration::Preint3dLog, Integration::Preint3dOctave})
    EXPECT_LE(compareImages(drawn(march, camera, method), drawn(march, camera, method, /*forceFetch=*/true)).max, 1e-3)
        << integrationName(method);
}

// More cells than one dispatch walks, at each of whose ends a method searches among a hundred pieces of the transfer
// function. All but the first and the last layer have one scalar; a search that is cut short ends in a piece that is
// dense.
TEST_F(GpuTest, MarchGoesOnAfterManyCellsByEveryMethod) {
  constexpr double kScalar = 0.0522;
  const TetMesh mesh = kuhnGrid(1, 1, 4000, glm::dvec3(0), glm::dvec3(1), [](const glm::dvec3& p) {
    return p.z == 0.0 ? 0.0 : p.z == 1.0 ? 0.1 : kScalar;
  });
  std::vector<ControlPoint> points;
  for (int i = -101; i <= 101; i++) {
    const bool isDense = std::abs(i) > 2 && std::abs(i) < 101;
    points.push_back({kScalar + i * 1e-5, {0.3, 0.6, 0.9}, isDense ? 400.0 : 1.5});
  }
  Renderer march(context(), mesh, scalarField(mesh, "", "test"), withProjection(CellProjection::March));
  march.setTransferFunction(TransferFunction(points, "many pieces"));
  Camera camera;
  camera.eye = {0.43, 0.47, -2};
  camera.center = {0.43, 0.47, 0};
  camera.up = {0, 1, 0};
  camera.projection = Projection::Orthographic;
  camera.heightWorld = 0.5;
  for (const Integration method :
       {Integration::Exact, Integration::Linear, Integration::Moments, Integration::Average, Integration::Vertex}) {
    const Image image = drawn(march, camera, method, /*forceFetch=*/false, {16, 12});
    const glm::vec4& pixel = image.at(8, 6);
    EXPECT_NEAR(pixel.w, -std::expm1(-1.5), 5e-3) << integrationName(method);
    EXPECT_NEAR(pixel.z, -0.9 * std::expm1(-1.5), 5e-3) << integrationName(method);
  }
}

}  // namespace
}  // namespace tetralux::render
