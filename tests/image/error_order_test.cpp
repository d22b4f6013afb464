// Methods of integration in the order of their errors, where theory puts them in one. docs/integration.md has the
// figures, and says which orders of the literature are chance.
//
// Theory, for a segment of optical depth M, and dL the range of luminance along it:
//   exact     errs by rounding alone
//   moments   opacity exactly, light to 0.016 M^3 dL: whatever the transfer function does between the ends
//   ends      (linear, ppi, average, vertex, opacity2d) do not see a peak between the ends
//   tables    (preint*) see it, blurred to the distance of two entries in the scalar
// Between the methods of the ends, on peaks, it is chance which end happens to lie on the peak, so nothing is said of
// that.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/trigonometric.hpp>
#include <map>

#include "gpu_fixture.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "mesh/generate.h"
#include "mesh/mesh_io.h"
#include "reference/ray_caster.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "support/shared_data.h"

namespace tetralux::render {
namespace {

using enum Integration;
using Errors = std::map<Integration, double>;  // RMSE

constexpr Integration kEnds[] = {Linear, Ppi, Average, Vertex, Opacity2d};
constexpr Integration kLogTables[] = {Preint3dLog, Preint3dOctave};

// Everything that a picture is made of, and the exact one.
struct ErrorCase {
  TetMesh mesh;
  ScalarField field;
  TransferFunction transfer;
  Camera camera;
  Image exact;

  ImageSize size() const { return {exact.width, exact.height}; }
};

// The middle of a shared scene, a quarter as high and wide, and of its exact image: the same rays through the same
// pixels' centres.
ErrorCase sharedCase(const std::string& name) {
  constexpr std::uint32_t kPart = 4;
  Scene scene = readScene(test::sharedPath("scenes/" + name + ".json"));
  scene.camera.heightWorld /= kPart;
  scene.camera.fovyDegrees =
      glm::degrees(2.0 * std::atan(std::tan(0.5 * glm::radians(scene.camera.fovyDegrees)) / kPart));
  const Image whole = readExr(test::sharedPath("reference/" + name + ".exr"));
  Image middle(whole.width / kPart, whole.height / kPart);
  for (std::uint32_t y = 0; y < middle.height; y++) {
    for (std::uint32_t x = 0; x < middle.width; x++)
      middle.at(x, y) = whole.at(x + (whole.width - middle.width) / 2, y + (whole.height - middle.height) / 2);
  }
  ErrorCase c{readMesh(scene.meshPath), {}, scene.transferFunction, scene.camera, std::move(middle)};
  c.field = scalarField(c.mesh, scene.fieldName, name);
  return c;
}

ErrorCase generatedCase(TetMesh mesh, const std::vector<ControlPoint>& points, const Camera& camera) {
  ErrorCase c{std::move(mesh), {}, TransferFunction(points, "t"), camera, Image(96, 72)};
  c.field = scalarField(c.mesh, "", "test");
  c.exact = reference::toImage(reference::renderPixels({c.mesh, c.field, c.transfer, camera, c.size()}), c.size());
  return c;
}

// Rays that walk have the segments of every other projection, and no order to sort into; only `vertex` needs fans. They
// also see what a table blurs into cells that the transfer function leaves empty, which other projections cull.
Errors errorsOf(const gpu::Context& context, const ErrorCase& c, CellProjection projection = CellProjection::March) {
  RendererOptions rendererOptions;
  rendererOptions.projection = projection;
  Renderer renderer(context, c.mesh, c.field, rendererOptions);
  renderer.setTransferFunction(c.transfer);
  Errors errors;
  for (const std::string& name : integrationNames()) {
    RenderOptions options;
    options.integration = parseIntegration(name);
    renderer.draw(c.camera, c.size(), options);
    const ImageDifference d = compareImages(c.exact, renderer.readImage());
    EXPECT_EQ(d.nonFinite, 0u) << name;
    errors[options.integration] = d.rmse;
  }
  return errors;
}

// The error of `better` is at most `factor` times that of `worse`.
void expectBelow(const Errors& errors, Integration better, Integration worse, double factor = 1.0) {
  EXPECT_LE(errors.at(better), factor * errors.at(worse))
      << integrationName(better) << " against " << integrationName(worse);
}

// exact <= moments <= every other, for cells of an optical depth up to about 1. Where both err by rounding alone, they
// differ by chance.
void expectExactThenMoments(const Errors& errors) {
  EXPECT_LE(errors.at(Exact), 5e-5);
  EXPECT_LE(errors.at(Exact), 1.05 * errors.at(Moments) + 1e-7);
  for (const auto& [method, error] : errors) {
    if (method != Exact && method != Moments) expectBelow(errors, Moments, method);
  }
}

// A peak between the ends: the logarithmic tables, which know thin cells, see it; the ends do not.
void expectPeaksSeenByTables(const Errors& errors, double factor) {
  for (const Integration table : kLogTables) {
    for (const Integration ends : kEnds) expectBelow(errors, table, ends, factor);
    expectBelow(errors, Moments, table, 0.1);
  }
  // Psi is interpolated instead of computed: what both assume is the same.
  EXPECT_NEAR(errors.at(Ppi), errors.at(Linear), 0.01 * errors.at(Linear));
}

// Smooth transfer functions are nearly linear along a segment. With tau'' and L'' the same along it, the trapezoid
// (`linear`) errs by -h^2/12 of them and the midpoint (`average`) by h^2/24, the other way. The fraction of the
// logarithm lets `preint3d-log` overestimate thin cells by up to 6 % whatever the resolution; the octaves' coordinate
// has the same entries and no bias.
void expectSmoothOrder(const Errors& errors) {
  expectBelow(errors, Average, Linear, 0.95);
  expectBelow(errors, Preint3dOctave, Preint3dLog, 0.2);
  EXPECT_NEAR(errors.at(Ppi), errors.at(Linear), 0.01 * errors.at(Linear));
}

// ---- generated scenes ----

std::vector<ControlPoint> peak(double center, double halfWidth, double tau) {
  const glm::dvec3 dim(0.1, 0.2, 0.9), bright(0.9, 0.6, 0.1);
  return {{0, dim, 0.1},
          {center - halfWidth, dim, 0.1},
          {center, bright, tau},
          {center + halfWidth, dim, 0.1},
          {1, dim, 0.1}};
}

Camera outside() {
  Camera camera;
  camera.eye = {2.3, -1.9, 1.6};
  camera.center = {0.5, 0.5, 0.5};
  camera.fovyDegrees = 40;
  return camera;
}

class ErrorOrder : public test::GpuTest {};

// A cell's range of scalars is many times the peak's width.
TEST_F(ErrorOrder, NarrowPeaksInLargeCells) {
  const Errors errors =
      errorsOf(context(), generatedCase(jitteredGrid(5, 5, 5, glm::dvec3(0), glm::dvec3(1), 0.15, 3, waveField),
                                        peak(0.5, 0.005, 15), outside()));
  expectExactThenMoments(errors);
  expectPeaksSeenByTables(errors, 0.5);
}

// A cell's range is a part of the peak's width: what sees the ends alone converges, by the square of the cells' size.
TEST_F(ErrorOrder, WidePeaksInSmallCells) {
  Errors coarse, fine;
  for (const std::uint32_t n : {8u, 16u}) {
    const Errors errors =
        errorsOf(context(), generatedCase(jitteredGrid(n, n, n, glm::dvec3(0), glm::dvec3(1), 0.15, 3, waveField),
                                          peak(0.5, 0.35, 2), outside()));
    expectExactThenMoments(errors);
    expectSmoothOrder(errors);
    (n == 8 ? coarse : fine) = errors;
  }
  for (const Integration ends : {Linear, Ppi, Average, Opacity2d})
    EXPECT_LE(fine.at(ends), 0.4 * coarse.at(ends)) << integrationName(ends);
}

// Lengths of cells over four decades, thin ones in front of opaque ones: one slice of the linear axis holds all the
// thin ones. The transfer function is what `linear` and `ppi` assume.
TEST_F(ErrorOrder, ThicknessesOverDecades) {
  Camera camera;
  camera.eye = {-0.1, -0.08, -0.06};
  camera.center = {0.05, 0.05, 0.05};
  const std::vector<ControlPoint> ramp = {{0, {1, 0, 0.5}, 0}, {1, {0, 1, 0.5}, 60}};
  const Errors errors = errorsOf(context(), generatedCase(gradedBox(12, 1e4), ramp, camera));
  for (const Integration method : {Exact, Linear}) EXPECT_LE(errors.at(method), 5e-5) << integrationName(method);
  expectBelow(errors, Preint3dLog, Preint3d, 0.2);
  expectBelow(errors, Preint3dOctave, Preint3dLog, 0.7);
  for (const Integration method : {Preint2d, Preint3d, Preint3dLog, Preint3dOctave, Average, Opacity2d})
    expectBelow(errors, Moments, method, 0.2);
}

// ---- shared scenes ----

class SharedErrorOrder : public ErrorOrder, public ::testing::WithParamInterface<const char*> {};

TEST_P(SharedErrorOrder, IsWhatTheorySays) {
  const std::string name = GetParam();
  REQUIRE_SHARED("scenes/" + name + ".json");
  REQUIRE_SHARED("reference/" + name + ".exr");
  const ErrorCase c = sharedCase(name);
  const Errors errors = errorsOf(context(), c);
  expectExactThenMoments(errors);
  const bool isPeak = name.ends_with("peak");
  if (isPeak)
    expectPeaksSeenByTables(errors, 0.65);
  else
    expectSmoothOrder(errors);
  // Edges of these two meshes differ by a hundred times and more: thin cells decide.
  if (name.starts_with("bluntfin") || name.starts_with("oxygenpost")) {
    expectBelow(errors, Preint3dOctave, Preint3d, 0.8);
    if (isPeak) expectBelow(errors, Preint3dLog, Preint3d, 0.8);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SharedErrorOrder,
                         ::testing::Values("spx_smooth", "spx_peak", "spx_close", "bluntfin_smooth", "bluntfin_peak",
                                           "bluntfin_close", "combustor_peak", "combustor_close", "oxygenpost_smooth",
                                           "oxygenpost_peak"),
                         [](const auto& scene) { return std::string(scene.param); });

// Colours made at a fan's vertices and interpolated over its triangles are one assumption more than colours made at a
// ray's ends.
TEST_F(ErrorOrder, VerticesErrMoreThanRays) {
  REQUIRE_SHARED("scenes/spx_smooth.json");
  REQUIRE_SHARED("reference/spx_smooth.exr");
  const Errors errors = errorsOf(context(), sharedCase("spx_smooth"), CellProjection::Pt);
  for (const Integration ends : {Linear, Ppi, Average, Opacity2d}) expectBelow(errors, ends, Vertex, 0.5);
}

// Depths within a cell differ most where the eye is near (Kraus, Qiao and Ebert 2004, section 2.1); without
// perspective, what is linear in space is linear on the screen, and the two are one.
TEST_F(ErrorOrder, PerspectiveBeatsScreenInCloseViews) {
  const std::string names[] = {"spx_close", "spx_ortho"};
  for (const std::string& name : names) {
    REQUIRE_SHARED("scenes/" + name + ".json");
    REQUIRE_SHARED("reference/" + name + ".exr");
  }
  for (const std::string& name : names) {
    const ErrorCase c = sharedCase(name);
    Renderer renderer(context(), c.mesh, c.field);
    renderer.setTransferFunction(c.transfer);
    double error[2];
    for (const Interpolation interpolation : {Interpolation::Perspective, Interpolation::Screen}) {
      RenderOptions options;
      options.interpolation = interpolation;
      renderer.draw(c.camera, c.size(), options);
      error[interpolation == Interpolation::Screen ? 1 : 0] = compareImages(c.exact, renderer.readImage()).rmse;
    }
    if (c.camera.projection == Projection::Perspective)
      EXPECT_LE(error[0], 0.02 * error[1]) << name;
    else
      EXPECT_NEAR(error[0], error[1], 1e-6) << name;
  }
}

}  // namespace
}  // namespace tetralux::render
