// Frames drawn for a tolerance: the bounds that choices rest on, and the error of what is drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"
#include "reference/ray_caster.h"
#include "segments.h"

namespace tetralux::render {
namespace {

using test::GpuTest;
using test::integrateOnDevice;
using test::Segment;

constexpr int kSegments = 1000000;
constexpr double kRounding = 4e-6;  // of the exact method on the device, for any segment

// Nine control points, not monotone, luminance up to 1.
TransferFunction smoothTransfer() {
  return TransferFunction({{0.0, {0.1, 0.0, 0.9}, 0.2},
                           {0.1, {0.9, 0.2, 0.1}, 2.0},
                           {0.25, {0.2, 0.9, 0.3}, 0.0},
                           {0.4, {0.0, 0.1, 1.0}, 5.0},
                           {0.5, {1.0, 1.0, 0.0}, 1.0},
                           {0.62, {0.3, 0.0, 0.4}, 9.0},
                           {0.75, {0.0, 1.0, 0.1}, 3.0},
                           {0.9, {0.8, 0.3, 0.2}, 0.5},
                           {1.0, {0.1, 0.7, 1.0}, 20.0}},
                          "test");
}

double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

double largestChange(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = glm::abs(b - a);
  return std::max({d.x, d.y, d.z});
}

// NUMERICS' bound of the mean colour, for a cell whose scalars and lengths are those of one segment: then what
// tolerance/classify.comp finds for the cell is the least that may hold for the segment.
TEST_F(GpuTest, MeanColourStaysWithinItsBoundForAMillionCells) {
  const TransferFunction transfer = smoothTransfer();
  std::mt19937 random(11);
  std::vector<Segment> segments;
  for (int i = 0; i < kSegments; i++) {
    const TransferPiece& piece = transfer.pieces()[1 + random() % (transfer.pieces().size() - 2)];
    const double width = piece.high - piece.low;
    const double front = piece.low + width * (0.001 + 0.998 * uniform(random));
    const double back = piece.low + width * (0.001 + 0.998 * uniform(random));
    segments.push_back({front, back, std::exp2(-14.0 + 16.0 * uniform(random))});
  }
  const auto exact = integrateOnDevice(context(), transfer, segments);
  const auto mean = integrateOnDevice(context(), transfer, segments, Integration::Average);
  double tightest = 0.0;  // largest error through its bound
  for (int i = 0; i < kSegments; i++) {
    const OpticalSample a = transfer.at(segments[i].front);
    const OpticalSample b = transfer.at(segments[i].back);
    const double sum = a.extinction + b.extinction;
    const double delta = sum > 0.0 ? std::abs(a.extinction - b.extinction) / sum : 0.0;
    const double depth = std::max(a.extinction, b.extinction) * segments[i].length;
    const double bound = largestChange(a.luminance, b.luminance) * std::min(0.5, delta / 6.0 + depth / 12.0);
    const double alpha = static_cast<double>(exact[i].w);
    for (int c = 0; c < 3; c++) {
      const double error = std::abs(static_cast<double>(exact[i][c] - mean[i][c]));
      ASSERT_LE(error, bound * alpha + kRounding) << i;
      if (bound * alpha > 1e-3) tightest = std::max(tightest, error / (bound * alpha));
    }
    ASSERT_NEAR(static_cast<double>(mean[i].w), alpha, kRounding);
  }
  EXPECT_GT(tightest, 0.9);  // a bound that says nothing would hold, too
}

TEST_F(GpuTest, PartsStayWithinTheirBoundForAMillionCells) {
  const TransferFunction transfer = smoothTransfer();
  std::mt19937 random(12);
  std::vector<Segment> segments;
  for (int i = 0; i < kSegments; i++)
    segments.push_back({uniform(random), uniform(random), std::exp2(-14.0 + 16.0 * uniform(random))});
  double change = 0.0;
  for (const TransferPiece& piece : transfer.pieces())
    change = std::max(change, largestChange(piece.atLow.luminance, piece.atHigh.luminance));
  const auto exact = integrateOnDevice(context(), transfer, segments);
  for (const PartAccuracy accuracy : {PartAccuracy::Fine, PartAccuracy::Medium, PartAccuracy::Coarse}) {
    const auto found = integrateOnDevice(context(), transfer, segments, Integration::Exact, {}, {}, accuracy);
    const PartError error = partError(accuracy);
    const double bound = (error.opacity + error.moment * change) / (1.0 - error.opacity);
    double worst = 0.0;
    for (int i = 0; i < kSegments; i++) {
      ASSERT_NEAR(found[i].w, exact[i].w, error.opacity + kRounding);
      for (int c = 0; c < 3; c++) {
        const double difference = std::abs(static_cast<double>(exact[i][c] - found[i][c]));
        // Relative to the opacity, so that thousands of thin cells on a ray stay within it together.
        ASSERT_LE(difference, bound * static_cast<double>(exact[i].w) + kRounding) << partAccuracyName(accuracy);
        worst = std::max(worst, difference);
      }
    }
    EXPECT_GT(worst, 0.1 * bound) << partAccuracyName(accuracy);
  }
}

TEST_F(GpuTest, CellsAreClassifiedByWhatTheyNeed) {
  const TetMesh mesh = kuhnGrid(6, 6, 6, glm::dvec3(0), glm::dvec3(1), [](const glm::dvec3& p) { return p.x; });
  const ScalarField field = scalarField(mesh, "", "test");
  const GpuMesh gpuMesh(context(), mesh, field);
  const auto classes = [&](std::vector<ControlPoint> points, double limit) {
    const TransferBuffer transfer(context(), TransferFunction(std::move(points), "test"), gpuMesh.space());
    return classifyCells(context(), gpuMesh, transfer, /*wideAddressing=*/false, limit);
  };
  const std::uint32_t all = gpuMesh.cellCount();
  // One colour: the mean is right everywhere.
  EXPECT_EQ(classes({{0, {1, 1, 1}, 0}, {1, {1, 1, 1}, 9}}, 1e-9).average, all);
  // Another colour: not within a small limit, but within a large one; no control point is inside.
  EXPECT_EQ(classes({{0, {0, 1, 1}, 1}, {1, {1, 1, 1}, 9}}, 1e-9).linear, all);
  EXPECT_EQ(classes({{0, {0, 1, 1}, 1}, {1, {1, 1, 1}, 9}}, 0.1).average, all);
  // A control point in the middle of one slab of cells, and on the border of two.
  EXPECT_EQ(classes({{0, {1, 1, 1}, 1}, {0.25, {0, 1, 1}, 2}, {1, {1, 1, 1}, 1}}, 1e-9).pieces, all / 6);
  EXPECT_EQ(classes({{0, {1, 1, 1}, 1}, {0.5, {0, 1, 1}, 2}, {1, {1, 1, 1}, 1}}, 1e-9).pieces, 0u);
  // Nothing below a half.
  EXPECT_EQ(classes({{0, {1, 1, 1}, 0}, {0.5, {1, 1, 1}, 0}, {1, {1, 1, 1}, 1}}, 1e-9).empty, all / 2);
  // The change of luminance along a sixth of the range.
  EXPECT_NEAR(classes({{0, {0, 1, 1}, 1}, {1, {1, 1, 1}, 9}}, 1e-9).worstChange, 1.0 / 6.0, 1e-6);
}

TEST_F(GpuTest, FramesKeepTheirTolerance) {
  for (const auto& [name, mesh] : test::hardMeshes()) {
    const Camera camera = test::orderViews(mesh)[0];
    for (const double tolerance : {1.0 / 32.0, 1.0 / 128.0, 1.0 / 510.0}) {
      for (const CellProjection projection : {CellProjection::Auto, CellProjection::Silhouette}) {
        RendererOptions options = test::withProjection(projection);
        options.tolerance = tolerance;
        EXPECT_LE(test::projectionError(context(), mesh, camera, options).max, tolerance) << name;
      }
    }
  }
}

// A field of one value per cell has no gradient: every cell is the mean's.
TEST_F(GpuTest, CellFieldsAreDrawnByTheirMean) {
  TetMesh mesh = kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), waveField);
  std::vector<float> values;
  for (size_t i = 0; i < mesh.cellCount(); i++) values.push_back(static_cast<float>(i * 7919 % 100) / 99.0f);
  mesh.cellArrays.push_back({"c", 1, values});
  RendererOptions options;
  options.tolerance = 1.0 / 510.0;
  Renderer renderer(context(), mesh, scalarField(mesh, "c", "test"), options);
  renderer.setTransferFunction(smoothTransfer());
  const FrameStats stats = renderer.draw(test::orderViews(mesh)[0], test::kProjectionSize);
  EXPECT_EQ(stats.integration, Integration::Average);
  ASSERT_TRUE(stats.plan.has_value());
  EXPECT_EQ(stats.plan->tolerance, 1.0 / 510.0);
}

TEST_F(GpuTest, RaysWalkUnlessBlendingIsAskedFor) {
  RendererOptions options;
  options.projection = CellProjection::Auto;
  const TetMesh mesh = kuhnGrid(3, 3, 3, glm::dvec3(0), glm::dvec3(1), waveField);
  const auto chosen = [&] { return Renderer(context(), mesh, scalarField(mesh, "", "test"), options).projection(); };
  EXPECT_EQ(chosen(), CellProjection::March);
  options.mayWalk = false;
  EXPECT_EQ(chosen(), CellProjection::Silhouette);
  options.mayWalk = true;
  options.order = Order::Radix;
  EXPECT_EQ(chosen(), CellProjection::Silhouette);
}

}  // namespace
}  // namespace tetralux::render
