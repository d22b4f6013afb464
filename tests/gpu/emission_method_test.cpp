// Emission per unit of length by every method that can carry it.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "gpu_fixture.h"
#include "image/metrics.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"
#include "reference/ray_caster.h"
#include "segments.h"

namespace tetralux::render {
namespace {

using test::GpuTest;
using test::largestRelativeError;
using test::Segment;

std::vector<Integration> carrying() {
  std::vector<Integration> methods;
  for (const std::string& name : integrationNames()) {
    if (carriesEmissionPerLength(parseIntegration(name))) methods.push_back(parseIntegration(name));
  }
  return methods;
}

CellLengths lengthsUpTo(double longest) {
  CellLengths lengths;
  lengths.longest = static_cast<float>(longest);
  lengths.mean = lengths.longest;
  return lengths;
}

TableOptions stored(TableFormat format, std::array<std::uint32_t, 3> size = {0, 0, 0}) {
  TableOptions options;
  options.format = format;
  options.size = size;
  return options;
}

// Where neither changes along the segment all agree, whatever its thickness; only tables interpolate, and the one for
// one thickness is right at that one. Tables hold light per length, E (1 - exp(-m))/m: its curvature over the thickness
// is at most E tau^2/3, and the linear axis errs by h^2/8 of it; the logarithmic one by 1/32 of it between 1/2 and 1,
// and its fraction by 0.086 of the fall from 0.63 to 0.43 besides.
TEST_F(GpuTest, EmissionPerLengthIsExactForAConstantScalar) {
  const TransferFunction constant({{0, {0.3, 60, 0.9}, 2}}, "constant", Emission::PerLength);
  std::vector<Segment> segments;
  for (double length = 1e-6; length <= 1.0; length *= 1.3) segments.push_back({0.3, 0.3, length});
  for (const Integration method : carrying()) {
    SCOPED_TRACE(integrationName(method));
    TableOptions options = stored(TableFormat::F32);
    double limit = 2e-6;
    double opacityLimit = 1e-5;
    // The opacity's own error, relative to the least depth that it is divided by; what two entries differ by is what
    // the sampler's fraction costs.
    if (method == Integration::Opacity2d) {
      const double byFraction = test::samplerFractionError(context()) * 2.0 / 255.0;
      limit = 16.0 * (4.0 / 8.0 / (255.0 * 255.0) + byFraction) + 1e-5;
      opacityLimit += byFraction;
    }
    if (method == Integration::Preint3d) {
      options.size = {2, 2, 65};
      limit = opacityLimit = 4.0 / 8.0 / (64.0 * 64.0) / 0.43;
    }
    if (method == Integration::Preint3dLog || method == Integration::Preint3dOctave) {
      options.size = {2, 2, 16};
      limit = 4.0 / 3.0 / 32.0 / 0.43 + (method == Integration::Preint3dLog ? 0.086 * 0.2 / 0.43 : 0.0);
      opacityLimit = 0.07;
    }
    EXPECT_LE(largestRelativeError(context(), constant,
                                   method == Integration::Preint2d ? std::vector<Segment>{{0.3, 0.3, 1.0}} : segments,
                                   method, options, lengthsUpTo(1), opacityLimit),
              limit);
  }
}

// No absorption at all: light is the mean of the emission times the length. A linear emission is what every method
// assumes.
TEST_F(GpuTest, EmissionWithoutExtinctionIsExactForEveryMethod) {
  const TransferFunction clear({{0, {1, 0, 300}, 0}, {1, {0, 2, 300}, 0}}, "clear", Emission::PerLength);
  std::vector<Segment> segments;
  for (const double length : {1e-9, 1e-6, 1e-3, 0.7, 1.0}) {
    for (const auto& [front, back] :
         {std::pair(0.0, 1.0), std::pair(1.0, 0.0), std::pair(0.5, 0.5), std::pair(0.21, 0.37)})
      segments.push_back({front, back, length});
  }
  for (const Integration method : carrying()) {
    SCOPED_TRACE(integrationName(method));
    EXPECT_LE(largestRelativeError(context(), clear, segments, method, stored(TableFormat::F32), lengthsUpTo(1), 0.0),
              2e-6);
    // What a step of the format is, half of it, and the rounding of the fractions.
    EXPECT_LE(
        largestRelativeError(context(), clear, segments, method, stored(TableFormat::Unorm16), lengthsUpTo(1), 0.0),
        1.1 * 0.5 / 65535 + 2e-6);
  }
}

// linear.glsl where it is exact: depths at both ends over sixteen decades. Light may be tiny beside emission times
// length.
TEST_F(GpuTest, LinearEmissionPerLengthHasASmallRelativeErrorAtAllDepths) {
  std::vector<Segment> segments;
  const double scalars[] = {0.0, 1e-6, 1e-4, 0.01, 0.1, 0.3, 0.5, 0.5 + 1e-6, 0.7, 0.9, 1.0};
  for (double exponent = -8; exponent <= 8; exponent += 0.125) {
    for (const double front : scalars) {
      for (const double back : scalars) segments.push_back({front, back, std::pow(10.0, exponent)});
    }
  }
  for (const auto& points : {std::vector<ControlPoint>{{0, {1, 0, 0.5}, 0}, {1, {0, 1, 0.5}, 1}},
                             std::vector<ControlPoint>{{0, {0, 1e6, 0}, 1}, {1, {0, 0, 0}, 0}}})
    EXPECT_LE(largestRelativeError(context(), TransferFunction(points, "ramp", Emission::PerLength), segments,
                                   Integration::Linear),
              1e-5);
}

// Thin segments are summed by the thousand. What a fixed-point table holds does not become small with them; 100 times
// thinner than the first slice of a linear axis, all that is left is the format's step.
TEST_F(GpuTest, TablesKeepTheDigitsOfThinSegments) {
  const TransferFunction glow({{0, {0.2, 1, 3}, 1}, {1, {0.2, 2, 6}, 3}}, "glow", Emission::PerLength);
  std::vector<Segment> segments;
  for (const double length : {1e-7, 1e-5, 1e-4}) {
    for (const double front : {0.0, 0.3, 1.0}) segments.push_back({front, 0.4, length});
  }
  for (const Integration method : {Integration::Preint3d, Integration::Preint3dLog, Integration::Preint3dOctave}) {
    EXPECT_LE(
        largestRelativeError(context(), glow, segments, method, stored(TableFormat::Unorm16), lengthsUpTo(1), 1e-4),
        3e-4)
        << integrationName(method);
    EXPECT_LE(largestRelativeError(context(), glow, segments, method, stored(TableFormat::F32), lengthsUpTo(1), 1e-4),
              2e-4)
        << integrationName(method);
  }
}

// ---- pictures ----

// What each method makes of bands that glow and hide, at most: as measured, and half as much again.
TEST_F(GpuTest, MethodsErrWithinTheirMeansWithEmissionPerLength) {
  const TetMesh mesh = randomDelaunay(800, 1);
  const ScalarField field = scalarField(mesh, "", "test");
  const TransferFunction bands(test::orderTransfer().points(), "bands", Emission::PerLength);
  const std::map<Integration, double> limits = {
      {Integration::Exact, 5e-5},    {Integration::Linear, 4e-3},      {Integration::Average, 2.7e-3},
      {Integration::Vertex, 2.1e-2}, {Integration::Opacity2d, 4.2e-3}, {Integration::Preint2d, 9.2e-3},
      {Integration::Preint3d, 3e-4}, {Integration::Preint3dLog, 5e-3}, {Integration::Preint3dOctave, 1.3e-3}};
  for (const CellProjection projection : {CellProjection::Pt, CellProjection::Silhouette}) {
    Renderer renderer(context(), mesh, field, test::withProjection(projection));
    renderer.setTransferFunction(bands);
    for (const Camera& camera : {test::orderViews(mesh)[0], test::orderViews(mesh)[3]}) {
      const Image exact = reference::toImage(
          reference::renderPixels({mesh, field, bands, camera, test::kProjectionSize}), test::kProjectionSize);
      for (const auto& [method, limit] : limits) {
        RenderOptions options;
        options.integration = method;
        renderer.draw(camera, test::kProjectionSize, options);
        const ImageDifference d = compareImages(exact, renderer.readImage());
        EXPECT_LE(d.rmse, limit) << integrationName(method) << ", " << projectionName(projection);
        EXPECT_EQ(d.nonFinite, 0u);
      }
    }
  }
}

}  // namespace
}  // namespace tetralux::render
