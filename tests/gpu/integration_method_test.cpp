// Every method of integration: exact where theory says so, and as wrong as it may be elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "gpu_fixture.h"
#include "image/metrics.h"
#include "mesh/generate.h"
#include "reference/ray_caster.h"
#include "reference/segment_integral.h"
#include "render/renderer.h"
#include "segments.h"

namespace tetralux::render {
namespace {

using test::GpuTest;
using test::integrateOnDevice;
using test::largestError;
using test::Segment;

std::vector<Integration> allMethods() {
  std::vector<Integration> all;
  for (const std::string& name : integrationNames()) all.push_back(parseIntegration(name));
  return all;
}

const TransferFunction& ramp() {
  static const TransferFunction transfer({{0, {1, 0, 0.5}, 0}, {1, {0, 1, 0.5}, 1}}, "ramp");
  return transfer;
}

// Four peaks of one hundredth of the range.
const TransferFunction& peaks() {
  static const TransferFunction transfer = [] {
    std::vector<ControlPoint> points = {{0, {0.1, 0.2, 0.9}, 0.1}};
    for (const double s : {0.2, 0.4, 0.6, 0.8}) {
      points.push_back({s - 0.005, {0.1, 0.2, 0.9}, 0.1});
      points.push_back({s, {0.9, s, 0.1}, 60.0});
      points.push_back({s + 0.005, {0.1, 0.2, 0.9}, 0.1});
    }
    points.push_back({1, {0.1, 0.2, 0.9}, 0.1});
    return TransferFunction(points, "peaks");
  }();
  return transfer;
}

std::vector<Segment> randomSegments(int count, double longest) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Segment> segments;
  for (int i = 0; i < count; i++)
    segments.push_back({uniform(random), uniform(random), longest * std::pow(10.0, -3 * uniform(random))});
  return segments;
}

CellLengths lengthsUpTo(double longest) {
  CellLengths lengths;
  lengths.longest = static_cast<float>(longest);
  lengths.mean = lengths.longest;
  return lengths;
}

// Where nothing changes along the segment all agree; only tables round, and the two tables with a coarse axis of
// thickness interpolate an exponential. The table for one thickness is right at that one.
TEST_F(GpuTest, EveryMethodIsExactForAConstantScalar) {
  const TransferFunction constant({{0, {0.3, 0.6, 0.9}, 2}}, "constant");
  std::vector<Segment> segments;
  for (double length = 1e-4; length <= 1.0; length *= 1.3) segments.push_back({0.3, 0.3, length});
  TableOptions options;
  options.format = TableFormat::F32;
  for (const Integration method : allMethods()) {
    SCOPED_TRACE(integrationName(method));
    if (method == Integration::Preint2d) {
      EXPECT_LE(largestError(context(), constant, {{0.3, 0.3, 1.0}}, method, options, lengthsUpTo(1)), 2e-6);
      continue;
    }
    // What two entries differ by is what the sampler's fraction costs, which has 8 bits on NVIDIA's H200.
    const double fraction = test::samplerFractionError(context());
    double limit = 2e-6;
    // Linear interpolation errs by h^2/8 times the second derivative, 4 exp(-2 l). The coarsest step of the logarithmic
    // axes is from 1/2 to 1; there the fraction of the logarithm is off by up to 0.086 of the rise of 0.23 in addition.
    if (method == Integration::Preint3d) options.size = {2, 2, 65};
    if (method == Integration::Preint3dLog || method == Integration::Preint3dOctave) options.size = {2, 2, 16};
    if (method == Integration::Preint3d) limit = 4.0 / 8.0 / (64.0 * 64.0) + 1e-6 + fraction * 2.0 / 64.0;
    if (method == Integration::Opacity2d) limit = 4.0 / 8.0 / (255.0 * 255.0) + 1e-6 + fraction * 2.0 / 255.0;
    if (method == Integration::Preint3dOctave) limit = 0.5 * 0.5 / 8.0 * 4.0 * std::exp(-1.0);
    if (method == Integration::Preint3dLog) limit = 0.5 * 0.5 / 8.0 * 4.0 * std::exp(-1.0) + 0.086 * 0.233;
    EXPECT_LE(largestError(context(), constant, segments, method, options, lengthsUpTo(1)), limit);
    options.size = {0, 0, 0};
  }
}

TEST_F(GpuTest, LinearTransferFunctionsAreExactForTheMethodsThatAssumeThem) {
  const std::vector<Segment> segments = randomSegments(5000, 10.0);
  EXPECT_LE(largestError(context(), ramp(), segments, Integration::Exact), 1e-5);
  EXPECT_LE(largestError(context(), ramp(), segments, Integration::Linear), 1e-5);
  // Bilinear interpolation of Psi at 512 x 512, worst at its singular corner.
  EXPECT_LE(largestError(context(), ramp(), segments, Integration::Ppi), 2e-3);
  // 0.016 M^3 for an optical depth of M <= 0.5, and what is below rounding for thin ones.
  EXPECT_LE(largestError(context(), ramp(), randomSegments(5000, 0.5), Integration::Moments), 0.01604 * 0.125);
  EXPECT_LE(largestError(context(), ramp(), randomSegments(5000, 0.05), Integration::Moments), 0.01604 * 1.3e-4);
}

// The stable form of linear.glsl over sixteen decades, both orders of the ends: no branch may leave a gap.
TEST_F(GpuTest, LinearIsStableForAllOpticalDepths) {
  std::vector<Segment> segments;
  for (double exponent = -8; exponent <= 8; exponent += 0.125) {
    for (const auto& [front, back] :
         {std::pair(0.0, 1.0), std::pair(1.0, 0.0), std::pair(0.5, 0.5), std::pair(0.0, 0.0), std::pair(1e-6, 1.0),
          std::pair(0.3, 0.7), std::pair(0.5, 0.5 + 1e-6)})
      segments.push_back({front, back, std::pow(10.0, exponent)});
  }
  EXPECT_LE(largestError(context(), ramp(), segments, Integration::Linear), 1e-5);
}

TEST_F(GpuTest, MomentsHaveExactOpacity) {
  const std::vector<Segment> segments = randomSegments(20000, 3.0);
  const auto found = integrateOnDevice(context(), peaks(), segments, Integration::Moments);
  for (size_t i = 0; i < segments.size(); i++) {
    const Segment s = test::roundedSegment(segments[i]);
    const SegmentOptics expected = reference::integrateSegment(peaks(), s.front, s.back, s.length);
    const double depth = -std::log1p(-expected.alpha);
    // Rounding of a scalar inside a ramp of width 0.005.
    ASSERT_NEAR(found[i].w, expected.alpha, 5e-5) << s.front << " " << s.back << " " << s.length;
    for (int c = 0; c < 3; c++) {
      ASSERT_NEAR(found[i][c], expected.light[c], 0.01604 * std::min(depth * depth * depth, 50.0) + 5e-5);
      ASSERT_GE(found[i][c], 0.0f);
    }
  }
}

TEST_F(GpuTest, MomentsAreRightOnAndAroundControlPoints) {
  std::vector<Segment> segments;
  for (const ControlPoint& p : peaks().points()) {
    for (const double offset : {0.0, 1e-7, -1e-7, 1e-5, -1e-5, 1e-3, -1e-3}) {
      for (const double other : {0.0, 1e-7, -1e-7, 1e-4, 0.2, -0.2, 1.0, -1.0}) {
        const double front = std::clamp(p.s + offset, 0.0, 1.0);
        segments.push_back({front, std::clamp(front + other, 0.0, 1.0), 0.005});
      }
    }
  }
  EXPECT_LE(largestError(context(), peaks(), segments, Integration::Moments), 0.01604 * 0.027 + 5e-5);
}

// Interpolation in the shader and in the sampler are the same thing; samplers of devices may round fractions to 8 bits.
TEST_F(GpuTest, TablesAreInterpolatedAlikeByShaderAndSampler) {
  const std::vector<Segment> segments = randomSegments(2000, 1.0);
  for (const Integration method : {Integration::Ppi, Integration::Opacity2d, Integration::Preint2d,
                                   Integration::Preint3d, Integration::Preint3dLog, Integration::Preint3dOctave}) {
    TableOptions options;
    options.size = {33, 17, 9};
    const auto bySampler = integrateOnDevice(context(), ramp(), segments, method, options);
    options.forceFetch = true;
    const auto byShader = integrateOnDevice(context(), ramp(), segments, method, options);
    for (size_t i = 0; i < segments.size(); i++) {
      for (int c = 0; c < 4; c++)
        ASSERT_NEAR(bySampler[i][c], byShader[i][c], 1e-3) << integrationName(method) << " " << i;
    }
  }
}

TEST_F(GpuTest, MeanThicknessIsExtrapolatedLinearlyUntilOpaque) {
  const TransferFunction constant({{0, {0.3, 0.6, 0.9}, 2}}, "constant");
  CellLengths lengths;
  lengths.mean = 0.25f;
  const auto found = integrateOnDevice(context(), constant, {{0.5, 0.5, 0.125}, {0.5, 0.5, 0.5}, {0.5, 0.5, 10.0}},
                                       Integration::Preint2d, {}, lengths);
  const double opacity = -std::expm1(-0.5);
  EXPECT_NEAR(found[0].w, 0.5 * opacity, 1e-4);
  EXPECT_NEAR(found[1].w, 2.0 * opacity, 1e-4);
  EXPECT_NEAR(found[2].w, 1.0, 1e-6);
  EXPECT_NEAR(found[2].x, 0.3, 1e-4);
}

TEST_F(GpuTest, CellLengthsAreMeasured) {
  // A regular tetrahedron of edge 1: volume sqrt(2)/12, surface sqrt(3).
  TetMesh mesh;
  mesh.points = std::vector<glm::dvec3>{
      {0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {0.5, std::sqrt(0.75) / 3, std::sqrt(2.0 / 3)}};
  mesh.cells = {{0, 1, 2, 3}};
  addPointField(mesh, "scalar", waveField);
  const GpuMesh gpuMesh(context(), mesh, scalarField(mesh, "", "test"));
  for (const bool wideAddressing : {false, true}) {
    const CellLengths lengths = measureCellLengths(context(), gpuMesh, wideAddressing);
    const double scale = gpuMesh.space().scale;
    EXPECT_NEAR(static_cast<double>(lengths.longest) * scale, 1.0, 1e-6);
    EXPECT_NEAR(static_cast<double>(lengths.mean) * scale, 4.0 * std::sqrt(2.0) / 12.0 / std::sqrt(3.0), 1e-6);
  }
}

// ---- pictures ----

struct PictureCase {
  TetMesh mesh;
  ScalarField field;
  Camera camera;
  ImageSize size{96, 72};

  explicit PictureCase(TetMesh tetMesh) : mesh(std::move(tetMesh)), field(scalarField(mesh, "", "test")) {
    std::vector<glm::dvec3> points(mesh.pointCount());
    for (size_t i = 0; i < points.size(); i++) points[i] = mesh.point(i);
    camera = framingCamera(points, size);
  }
};

TransferFunction over(const ScalarField& field, const TransferFunction& transfer, double factor) {
  std::vector<ControlPoint> points = transfer.points();
  for (ControlPoint& p : points) {
    p.s = field.low + p.s * (field.high - field.low);
    p.tau *= factor;
  }
  return TransferFunction(points, "t");
}

std::map<Integration, double> errorsOf(const gpu::Context& context, const PictureCase& c,
                                       const TransferFunction& transfer) {
  const Image exact =
      reference::toImage(reference::renderPixels({c.mesh, c.field, transfer, c.camera, c.size}), c.size);
  Renderer renderer(context, c.mesh, c.field);
  renderer.setTransferFunction(transfer);
  std::map<Integration, double> errors;
  for (const Integration method : allMethods()) {
    RenderOptions options;
    options.integration = method;
    renderer.draw(c.camera, c.size, options);
    const ImageDifference d = compareImages(exact, renderer.readImage());
    EXPECT_EQ(d.nonFinite, 0u) << integrationName(method);
    errors[method] = d.rmse;
  }
  return errors;
}

using enum Integration;

// Narrow peaks in coarse cells: what sees only the ends of a segment misses them (RMSE 0.13), tables blur them (0.016),
// what knows the transfer function does not.
TEST_F(GpuTest, MethodsErrAsMuchAsTheyAssumeOnPeaks) {
  const PictureCase c(randomDelaunay(800, 1));
  auto error = errorsOf(context(), c, over(c.field, peaks(), 1.0));
  EXPECT_LE(error[Exact], 1e-5);
  EXPECT_LE(error[Exact], error[Moments]);
  for (const Integration table : {Preint3d, Preint3dLog, Preint3dOctave, Preint2d}) {
    EXPECT_LE(error[Moments], 0.25 * error[table]) << integrationName(table);
    for (const Integration ends : {Linear, Ppi, Average, Opacity2d, Vertex})
      EXPECT_LE(error[table], 0.25 * error[ends]) << integrationName(table) << " " << integrationName(ends);
  }
  EXPECT_NEAR(error[Ppi], error[Linear], 1e-5);
}

// Few wide pieces: every method is within its means, and colours at vertices are the worst of them.
TEST_F(GpuTest, MethodsErrAsMuchAsTheyAssumeOnBands) {
  const PictureCase c(randomDelaunay(800, 1));
  const TransferFunction bands({{0, {0.1, 0.1, 0.8}, 0.1},
                                {0.3, {0.1, 0.7, 0.2}, 2},
                                {0.5, {0.9, 0.8, 0.1}, 0},
                                {0.7, {0.9, 0.3, 0.1}, 6},
                                {1, {0.8, 0.1, 0.3}, 1}},
                               "bands");
  auto error = errorsOf(context(), c, over(c.field, bands, 1.0));
  EXPECT_LE(error[Exact], 1e-5);
  EXPECT_LE(error[Exact], error[Moments]);
  EXPECT_LE(error[Moments], 0.1 * error[Preint3d]);
  EXPECT_LE(error[Preint3d], error[Preint3dOctave]);
  EXPECT_LE(error[Preint3dOctave], 0.5 * error[Preint3dLog]);
  for (const Integration method : {Linear, Ppi, Average, Opacity2d, Preint2d, Preint3dLog})
    EXPECT_LE(error[method], 0.6 * error[Vertex]) << integrationName(method);
}

// Smooth optics, and cells that are opaque beside others that are 10,000 times thinner, seen through the thin ones.
TEST_F(GpuTest, LogarithmicThicknessServesMeshesOfLargeEdgeRatio) {
  PictureCase c(gradedBox(12, 1e4));
  c.camera.eye = {-0.1, -0.08, -0.06};
  c.camera.center = {0.05, 0.05, 0.05};
  auto error = errorsOf(context(), c, over(c.field, ramp(), 60.0));
  for (const Integration method : {Exact, Linear, Ppi}) EXPECT_LE(error[method], 1e-6) << integrationName(method);
  EXPECT_LE(error[Moments], 5e-5);
  EXPECT_LE(error[Preint3dLog], 0.2 * error[Preint3d]);
  EXPECT_LE(error[Preint3dOctave], 0.7 * error[Preint3dLog]);
  EXPECT_LE(error[Average], 0.2 * error[Vertex]);
}

// The lists of fragments per pixel hold what every method gives.
TEST_F(GpuTest, MethodsGiveTheSameThroughTheKBuffer) {
  const PictureCase c(randomDelaunay(300, 2));
  const TransferFunction transfer = over(c.field, ramp(), 2.0);
  RendererOptions options;
  Renderer sorted(context(), c.mesh, c.field, options);
  options.order = Order::KBuffer;
  options.kBuffer = 16;
  Renderer buffered(context(), c.mesh, c.field, options);
  for (Renderer* renderer : {&sorted, &buffered}) renderer->setTransferFunction(transfer);
  for (const Integration method : allMethods()) {
    RenderOptions frame;
    frame.integration = method;
    sorted.draw(c.camera, c.size, frame);
    buffered.draw(c.camera, c.size, frame);
    const ImageDifference d = compareImages(sorted.readImage(), buffered.readImage());
    // Under `vertex` a fragment has no depth of its own but its cell's.
    EXPECT_LE(d.rmse, method == Vertex ? 2e-2 : 1e-5) << integrationName(method);
    EXPECT_EQ(d.nonFinite, 0u);
  }
}

// Under an orthographic view, everything is linear on the screen; under a perspective one the error is of the cells'
// size.
TEST_F(GpuTest, ScreenInterpolationIsRightWithoutPerspective) {
  PictureCase c(randomDelaunay(300, 2));
  const TransferFunction transfer = over(c.field, ramp(), 2.0);
  Renderer renderer(context(), c.mesh, c.field);
  renderer.setTransferFunction(transfer);
  for (const bool perspective : {true, false}) {
    if (!perspective) {
      c.camera.projection = Projection::Orthographic;
      c.camera.heightWorld = 1.8;
    }
    const Image exact =
        reference::toImage(reference::renderPixels({c.mesh, c.field, transfer, c.camera, c.size}), c.size);
    RenderOptions options;
    options.interpolation = Interpolation::Screen;
    const FrameStats stats = renderer.draw(c.camera, c.size, options);
    EXPECT_EQ(stats.interpolation, Interpolation::Screen);
    const ImageDifference d = compareImages(exact, renderer.readImage());
    EXPECT_EQ(d.nonFinite, 0u);
    if (perspective) {
      EXPECT_GT(d.rmse, 1e-4);
      EXPECT_LT(d.rmse, 1e-2);
    } else {
      EXPECT_LT(d.rmse, 5e-5);
    }
  }
}

// A table is made for the first frame that needs it, and again for another transfer function, unless it does not depend
// on it.
TEST_F(GpuTest, TablesAreRebuiltWhenTheTransferFunctionChanges) {
  const PictureCase c(randomDelaunay(100, 2));
  Renderer renderer(context(), c.mesh, c.field);
  const auto picture = [&](Integration method, double tau) {
    renderer.setTransferFunction(over(c.field, ramp(), tau));
    RenderOptions options;
    options.integration = method;
    renderer.draw(c.camera, c.size, options);
    return renderer.readImage();
  };
  for (const Integration method : {Preint2d, Preint3d, Opacity2d, Moments, Ppi}) {
    const Image first = picture(method, 2.0);
    EXPECT_GT(compareImages(first, picture(method, 4.0)).rmse, 0.01) << integrationName(method);
    EXPECT_EQ(compareImages(first, picture(method, 2.0)).max, 0.0) << integrationName(method);
  }
  picture(Exact, 2.0);
  const std::uint64_t before = renderer.memoryUse().tableBytes;
  picture(Preint3d, 2.0);
  EXPECT_GE(renderer.memoryUse().tableBytes, before + 128 * 128 * 32 * 8);
  picture(Exact, 2.0);
  EXPECT_EQ(renderer.memoryUse().tableBytes, before);
}

}  // namespace
}  // namespace tetralux::render
