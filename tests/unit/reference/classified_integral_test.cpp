#include "reference/classified_integral.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "painted_box.h"
#include "reference/cell_ray.h"
#include "reference/pixel_tiles.h"
#include "reference/segment_integral.h"
#include "reference/smooth_integral.h"

namespace tetralux::reference {
namespace {

Modulation modulationBy(ModulatedBy by, std::vector<FactorPoint> points) {
  Modulation modulation;
  modulation.by = by;
  modulation.curve = FactorCurve(std::move(points), "test");
  return modulation;
}

const std::vector<ControlPoint> kWavy = {{0.1, {1, 0, 0.2}, 0.5}, {0.2, {0.5, 1, 0}, 3}, {0.35, {0, 0.3, 1}, 0},
                                         {0.6, {0, 0.3, 1}, 0},   {0.6, {1, 1, 1}, 8},   {0.9, {0.2, 0, 0}, 1}};

const std::vector<FactorPoint> kCurve = {{0.0, 0.2, {1, 0.5, 0}},
                                         {0.4, 1.5, {0, 1, 1}},
                                         {0.4, 0.3, {1, 1, 1}},
                                         {0.7, 0.0, {2, 0, 1}},
                                         {1.0, 1.0, {1, 1, 0}}};

TEST(Bernstein, ProductsAndIntegralsAreThoseOfTheirValues) {
  const Bernstein<double> a({1.0, 3.0});
  const Bernstein<double> b({0.0, 2.0, 5.0});
  const Bernstein<double> c({4.0});
  const Bernstein<double> product = a * b * c;
  EXPECT_EQ(product.degree(), 3u);
  for (const double x : {0.0, 0.1, 0.5, 0.77, 1.0}) {
    const double valueB = 2.0 * 2.0 * x * (1.0 - x) + 5.0 * x * x;
    EXPECT_NEAR(b.at(x), valueB, 1e-15);
    EXPECT_NEAR(product.at(x), (1.0 + 2.0 * x) * valueB * 4.0, 1e-13);
    // The integral of 4 x + x^2.
    EXPECT_NEAR(b.integral().at(x), 2.0 * x * x + x * x * x / 3.0, 1e-15);
  }
  EXPECT_EQ(c.at(0.3), 4.0);
  EXPECT_NEAR(c.integral().at(0.3), 1.2, 1e-15);
}

// int_0^1 exp(-m x^n) n m x^(n-1) dx = 1 - exp(-m), whatever m and n.
TEST(SmoothIntegral, IsExactForPowersOfAnyDepth) {
  for (const size_t n : {1u, 2u, 3u, 5u, 8u}) {
    for (const double m : {1e-12, 1e-3, 0.3, 1.0, 7.0, 100.0, 1e6, 1e12}) {
      std::vector<double> coefficients(n + 1, 0.0);
      coefficients.back() = m;
      const auto power = [&](double x) { return std::pow(x, static_cast<double>(n) - 1.0); };
      const SegmentOptics optics = SmoothIntegral(Bernstein<double>(coefficients))(
          [&](double x) { return glm::dvec3(m * static_cast<double>(n) * power(x)); });
      EXPECT_NEAR(optics.light.x / -std::expm1(-m), 1.0, 1e-13) << n << " " << m;
      EXPECT_NEAR(optics.alpha / -std::expm1(-m), 1.0, 1e-14);
    }
  }
}

Appearance modulated(std::vector<FactorPoint> points) {
  Appearance appearance;
  appearance.modulations = {modulationBy(ModulatedBy::Field, std::move(points))};
  return appearance;
}

ClassifiedSegment segmentOf(EndValues scalar, std::vector<EndValues> modulators, double length) {
  ClassifiedSegment segment;
  segment.scalar = scalar;
  segment.modulators = std::move(modulators);
  segment.length = length;
  return segment;
}

// A factor of 1 changes nothing: the integral of the transfer function alone, which is another formula.
TEST(ClassifiedIntegral, WithoutFactorsIsTheSegmentIntegral) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::uniform_real_distribution<double> exponent(-9.0, 6.0);
  const Appearance appearance = modulated({{0, 1, {1, 1, 1}}});
  for (const Emission emission : {Emission::PerExtinction, Emission::PerLength}) {
    const TransferFunction transfer(kWavy, "wavy", emission);
    for (int i = 0; i < 400; i++) {
      const double length = std::pow(10.0, exponent(random));
      const EndValues scalar = {uniform(random), i % 10 == 0 ? 0.6 : uniform(random)};
      const SegmentOptics a =
          integrateClassified(transfer, appearance, segmentOf(scalar, {{0, 1}}, length), 0, 1).optics;
      const SegmentOptics b = integrateSegment(transfer, scalar.front, scalar.back, length);
      const double scale = emission == Emission::PerLength ? std::max(1.0, length) : 1.0;
      EXPECT_NEAR(a.alpha, b.alpha, 1e-13 * std::min(1.0, 1e3 * length) + 1e-16);
      for (int c = 0; c < 3; c++) EXPECT_NEAR(a.light[c], b.light[c], 1e-13 * scale);
    }
  }
}

// A luminance that is the same everywhere gives L (1 - exp(-D)), and D has a closed form: of tau x^2 (1 - x), tau/12.
TEST(ClassifiedIntegral, OfOneLuminanceIsItsOpacity) {
  const TransferFunction transfer({{0, {0.5, 1, 0.25}, 3.0}}, "uniform");
  Appearance appearance;
  const std::vector<FactorPoint> rising = {{0, 0, {1, 1, 1}}, {1, 1, {1, 1, 1}}};
  const std::vector<FactorPoint> falling = {{0, 1, {1, 1, 1}}, {1, 0, {1, 1, 1}}};
  appearance.modulations = {modulationBy(ModulatedBy::Field, rising), modulationBy(ModulatedBy::Field, rising),
                            modulationBy(ModulatedBy::Field, falling)};
  for (const double length : {1e-9, 1e-3, 1.0, 40.0, 1e3, 1e7}) {
    const SegmentOptics optics =
        integrateClassified(transfer, appearance, segmentOf({0.3, 0.8}, {{0, 1}, {0, 1}, {0, 1}}, length), 0, 1).optics;
    const double alpha = -std::expm1(-3.0 * length / 12.0);
    EXPECT_NEAR(optics.alpha / alpha, 1.0, 1e-13);
    EXPECT_NEAR(optics.light.x / (0.5 * alpha), 1.0, 1e-13);
  }
}

// The same optics as a factor and as a transfer function.
TEST(ClassifiedIntegral, AFactorOfOneExtinctionIsATransferFunction) {
  const TransferFunction uniform({{0, {1, 1, 1}, 2.0}}, "uniform");
  std::vector<ControlPoint> points;
  for (const FactorPoint& p : kCurve) points.push_back({p.value, p.rgb, 2.0 * p.factor});
  const TransferFunction transfer(points, "curve");
  for (const auto& [a, b] : {std::pair(-0.2, 1.3), std::pair(0.95, 0.1), std::pair(0.4, 0.4), std::pair(0.7, 0.2)}) {
    for (const double length : {1e-6, 0.7, 300.0}) {
      const SegmentOptics x =
          integrateClassified(uniform, modulated(kCurve), segmentOf({0.1, 0.2}, {{a, b}}, length), 0, 1).optics;
      const SegmentOptics y = integrateSegment(transfer, a, b, length);
      EXPECT_NEAR(x.alpha, y.alpha, 1e-14);
      for (int c = 0; c < 3; c++) EXPECT_NEAR(x.light[c], y.light[c], 1e-14);
    }
  }
}

struct Steps {
  glm::dvec3 light{0.0};
  double depth = 0.0;
};

// The ray's equation step by step (the midpoint rule, extrapolated from steps of two lengths).
//   optics   of u: emitted light and extinction per world unit
template <typename Optics>
SegmentOptics bruteForce(double length, const Optics& optics) {
  const auto run = [&](int count) {
    Steps sum;
    for (int i = 0; i < count; i++) {
      const glm::dvec4 here = optics((i + 0.5) / count);
      const double step = length / count;
      sum.light += std::exp(-(sum.depth + 0.5 * here.w * step)) * step * glm::dvec3(here);
      sum.depth += here.w * step;
    }
    return sum;
  };
  // Kinks are at multiples of 1/1000 of the segment, so both kinds of step end at them.
  const Steps coarse = run(20000);
  const Steps fine = run(40000);
  SegmentOptics result;
  result.light = (4.0 * fine.light - coarse.light) / 3.0;
  result.alpha = -std::expm1(-(4.0 * fine.depth - coarse.depth) / 3.0);
  return result;
}

void expectNear(const SegmentOptics& a, const SegmentOptics& b, double tolerance) {
  EXPECT_NEAR(a.alpha, b.alpha, tolerance);
  for (int c = 0; c < 3; c++) EXPECT_NEAR(a.light[c], b.light[c], tolerance);
}

// Everything that may multiply at once: transfer function, two curves, lighting.
TEST(ClassifiedIntegral, AgreesWithBruteForce) {
  Appearance appearance = modulated(kCurve);
  appearance.modulations.push_back(modulationBy(ModulatedBy::ViewCosine, {{0.2, 2, {1, 1, 1}}, {0.9, 0.1, {0, 1, 2}}}));
  for (const Emission emission : {Emission::PerExtinction, Emission::PerLength}) {
    const TransferFunction transfer(kWavy, "wavy", emission);
    for (const double length : {0.8, 6.0}) {
      ClassifiedSegment segment = segmentOf({0.0, 1.0}, {{1.0, 0.0}, {0.1, 0.35}}, length);
      segment.lightFront = {{0.5, 1.0, 0.2}, {0.1, 0.0, 0.3}};
      segment.lightBack = {{1.0, 0.4, 0.9}, {0.0, 0.6, 0.2}};
      const SegmentOptics expected = bruteForce(length, [&](double u) {
        const OpticalSample sample = transfer.at(u);
        const FactorPoint f = appearance.modulations[0].curve.at(1.0 - u);
        const FactorPoint g = appearance.modulations[1].curve.at(0.1 + 0.25 * u);
        const double tau = sample.extinction * f.factor * g.factor;
        const glm::dvec3 factor = glm::mix(segment.lightFront.factor, segment.lightBack.factor, u);
        const glm::dvec3 highlight = glm::mix(segment.lightFront.highlight, segment.lightBack.highlight, u);
        const glm::dvec3 colour = sample.luminance * f.rgb * g.rgb * factor;
        return emission == Emission::PerLength ? glm::dvec4(colour * f.factor * g.factor, tau)
                                               : glm::dvec4(tau * (colour + highlight), tau);
      });
      expectNear(integrateClassified(transfer, appearance, segment, 0, 1).optics, expected, 1e-10);
    }
  }
}

TransferFunction2d smallGrid() {
  std::vector<OpticalSample> samples;
  for (int j = 0; j < 3; j++) {
    for (int i = 0; i < 4; i++) samples.push_back({{0.1 * i, 0.3 * j, 0.2 + 0.1 * i * j}, 0.5 * ((i * 3 + j * 2) % 5)});
  }
  return TransferFunction2d({0.1, 0.3, 0.6, 0.9}, {1.0, 2.0, 4.0}, samples, "grid");
}

TEST(ClassifiedIntegral, OfATransferFunctionOfTwoDimensionsAgreesWithBruteForce) {
  Appearance appearance;
  appearance.transfer2d = smallGrid();
  const TransferFunction unused({{0, {1, 1, 1}, 5}}, "unused", Emission::PerLength);
  for (const auto& [g0, g1] : {std::pair(0.0, 5.0), std::pair(3.0, 3.0), std::pair(4.0, 1.5)}) {
    ClassifiedSegment segment = segmentOf({1.0, 0.0}, {}, 2.0);
    segment.gradientMagnitude = {g0, g1};
    const SegmentOptics expected = bruteForce(2.0, [&](double u) {
      const OpticalSample sample = appearance.transfer2d->at(1.0 - u, g0 + (g1 - g0) * u);
      return glm::dvec4(sample.extinction * sample.luminance, sample.extinction);
    });
    expectNear(integrateClassified(unused, appearance, segment, 0, 1).optics, expected, 1e-10);
  }
}

// Closed form: an extinction of 6 s g between the samples 0, 0, 0 and 6 of a grid of one square.
TEST(ClassifiedIntegral, OfABilinearExtinctionIsTheClosedForm) {
  Appearance appearance;
  appearance.transfer2d =
      TransferFunction2d({0, 1}, {0, 1}, {{{1, 1, 1}, 0}, {{1, 1, 1}, 0}, {{1, 1, 1}, 0}, {{1, 1, 1}, 6}}, "square");
  for (const double length : {1e-6, 1.0, 1e5}) {
    ClassifiedSegment segment = segmentOf({0, 1}, {}, length);
    segment.gradientMagnitude = {1, 0};  // u (1 - u): 1/6
    const SegmentOptics optics = integrateClassified({}, appearance, segment, 0, 1).optics;
    EXPECT_NEAR(optics.alpha / -std::expm1(-length), 1.0, 1e-13);
    EXPECT_NEAR(optics.light.y / -std::expm1(-length), 1.0, 1e-13);
  }
}

TEST(ClassifiedIntegral, PartsCompositeToTheWhole) {
  const TransferFunction transfer(kWavy, "wavy");
  const Appearance appearance = modulated(kCurve);
  for (const double length : {1e-6, 0.3, 20.0}) {
    const ClassifiedSegment segment = segmentOf({0.97, 0.02}, {{0.1, 1.2}}, length);
    const SegmentOptics whole = integrateClassified(transfer, appearance, segment, 0, 1).optics;
    SegmentOptics sum;
    for (int i = 0; i < 137; i++) {
      const SegmentOptics part = integrateClassified(transfer, appearance, segment, i / 137.0, (i + 1) / 137.0).optics;
      sum.light += (1.0 - sum.alpha) * part.light;
      sum.alpha += (1.0 - sum.alpha) * part.alpha;
    }
    expectNear(sum, whole, 1e-13);
  }
}

// Numbers that are linear in the whole box make any ray through it one segment, whatever the cells.
TEST(Classification, OfLinearNumbersDoesNotDependOnTheMesh) {
  const auto scalar = [](const glm::dvec3& p) { return 0.3 * p.x + 0.5 * p.y + 0.2 * p.z; };
  const auto other = [](const glm::dvec3& p) { return 1.0 - 0.7 * p.x + 0.2 * p.y - 0.4 * p.z; };
  const auto third = [](const glm::dvec3& p) { return 1.0 + 2.0 * p.z; };
  const auto rgba = [&](const glm::dvec3& p) { return glm::dvec4(p, 2.0 * p.x + p.y); };
  PaintedBox box(randomDelaunay(400, 8, scalar));
  box.transfer = TransferFunction(kWavy, "wavy");
  const glm::dvec3 gradient(0.3, 0.5, 0.2);
  box.appearance = modulated(kCurve);
  box.appearance.modulations.push_back(
      modulationBy(ModulatedBy::GradientMagnitude, {{1, 1, {1, 1, 1}}, {4, 0, {1, 1, 1}}}));
  box.appearance.modulations.push_back(modulationBy(ModulatedBy::ViewCosine, {{0, 0, {1, 1, 1}}, {1, 1, {1, 1, 1}}}));
  box.data.modulators.resize(3);
  for (size_t i = 0; i < box.mesh.pointCount(); i++) {
    const glm::dvec3 p = box.mesh.point(i);
    box.data.modulators[0].push_back(other(p));
    box.data.modulators[1].push_back(third(p));
    box.data.gradients.push_back(gradient);
    box.data.gradientMagnitudes.push_back(third(p));
    box.data.rgba.push_back(rgba(p));
  }
  box.appearance.lighting.lights = {{glm::normalize(glm::dvec3(1, -1, 2)), {0.5, 0.6, 0.7}}};
  Isosurface surface;
  surface.value = 0.47;
  surface.opacity = 0.25;
  surface.shading = Shading::None;
  for (int variant = 0; variant < 4; variant++) {
    if (variant == 1) box.appearance.volumeShading = Shading::Phong;
    if (variant == 2) box.appearance.transfer2d = smallGrid();
    if (variant == 3) box.appearance.rgbaField = RgbaField{"rgb", "tau"};
    for (const glm::dvec3& eye : {glm::dvec3(-1, -2, -1.5), glm::dvec3(2, 2.5, 3), glm::dvec3(0.6, 0.1, 0.2)}) {
      for (const double aside : {0.0, 0.02, -0.05}) {
        const Ray ray = rayFrom(eye, glm::dvec3(0.52 + aside, 0.47, 0.45 - aside) - eye);
        const BoxChord chord(ray);
        const auto values = [&](const auto& number) {
          return EndValues{number(ray.origin + chord.front * ray.direction),
                           number(ray.origin + chord.back * ray.direction)};
        };
        const double cosine =
            std::abs(glm::dot(gradient, ray.direction)) / (glm::length(gradient) * ray.lengthPerDepth);
        ClassifiedSegment segment = segmentOf(values(scalar), {values(other), values(third), {cosine, cosine}},
                                              (chord.back - chord.front) * ray.lengthPerDepth);
        segment.gradientMagnitude = values(third);
        segment.rgbaFront = rgba(ray.origin + chord.front * ray.direction);
        segment.rgbaBack = rgba(ray.origin + chord.back * ray.direction);
        if (variant > 0)
          segment.lightFront = segment.lightBack =
              illuminate(box.appearance.lighting, gradient, -ray.direction / ray.lengthPerDepth);
        const SegmentOptics whole = integrateClassified(box.transfer, box.appearance, segment, 0, 1).optics;
        box.appearance.isosurfaces.clear();
        const ReferencePixel pixel = box.paint(ray);
        expectNear({pixel.light, pixel.alpha}, whole, 1e-10);
        // An isosurface in it.
        box.appearance.isosurfaces = {surface};
        const double u = (0.47 - segment.scalar.front) / (segment.scalar.back - segment.scalar.front);
        ASSERT_TRUE(u > 0.0 && u < 1.0);
        const SegmentOptics before = integrateClassified(box.transfer, box.appearance, segment, 0, u).optics;
        const SegmentOptics behind = integrateClassified(box.transfer, box.appearance, segment, u, 1).optics;
        SegmentOptics expected = before;
        expected.light += (1.0 - before.alpha) * (0.25 + 0.75 * behind.light);
        expected.alpha = 1.0 - (1.0 - before.alpha) * 0.75 * (1.0 - behind.alpha);
        const ReferencePixel cut = box.paint(ray);
        expectNear({cut.light, cut.alpha}, expected, 1e-10);
      }
    }
  }
}

// One cell: the two ends of the visible segment decide, and with a plane in the way the visible end moves.
TEST(Classification, IsLightedAtTheEndsOfTheVisibleSegment) {
  PaintedBox box(kuhnGrid(1, 1, 1, glm::dvec3(0), glm::dvec3(1), [](const glm::dvec3& p) { return p.x; }));
  box.mesh.cells.resize(1);
  const auto gradient = [](const glm::dvec3& p) { return glm::dvec3(1.0, 3.0 * p.x - p.y, p.z); };
  for (size_t i = 0; i < box.mesh.pointCount(); i++) box.data.gradients.push_back(gradient(box.mesh.point(i)));
  box.transfer = TransferFunction({{0, {0.5, 1, 0.25}, 1.5}}, "uniform");
  box.appearance.volumeShading = Shading::Phong;
  box.appearance.modulations = {modulationBy(ModulatedBy::ViewCosine, {{0, 0, {1, 1, 1}}, {1, 1, {1, 1, 1}}})};
  box.data.modulators.resize(1);
  const std::array<glm::dvec3, 4> corners = cellVertices(box.mesh, 0);
  const glm::dvec3 centre = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  const Ray ray = rayFrom(centre - glm::dvec3(2, 0.4, 0.6), glm::dvec3(1, 0.2, 0.3));
  CellSegment whole;
  ASSERT_TRUE(CellGeometry(corners, cellScalars(box.mesh, box.field, 0)).intersect(ray, whole));
  for (const bool isClipped : {false, true}) {
    if (isClipped) box.appearance.clip = {{{1, 0, 0}, centre.x}};
    const double front = isClipped ? 2.0 : whole.front;
    ClassifiedSegment segment = segmentOf({0, 1}, {EndValues{}}, (whole.back - front) * ray.lengthPerDepth);
    const auto cosine = [&](double depth) {
      const glm::dvec3 g = gradient(ray.origin + depth * ray.direction);
      return std::abs(glm::dot(glm::normalize(g), glm::normalize(ray.direction)));
    };
    const auto light = [&](double depth) {
      return illuminate(box.appearance.lighting, gradient(ray.origin + depth * ray.direction),
                        -glm::normalize(ray.direction));
    };
    segment.modulators[0] = {cosine(front), cosine(whole.back)};
    segment.lightFront = light(front);
    segment.lightBack = light(whole.back);
    const ReferencePixel pixel = box.paint(ray);
    expectNear({pixel.light, pixel.alpha}, integrateClassified(box.transfer, box.appearance, segment, 0, 1).optics,
               1e-13);
  }
}

TEST(Classification, OfAnInvisibleVolumeIsNothing) {
  PaintedBox box(kuhnGrid(2, 2, 2, glm::dvec3(0), glm::dvec3(1), waveField));
  box.transfer = TransferFunction({{0, {0.5, 1, 0.25}, 1.5}}, "uniform");
  box.appearance.volumeVisible = false;
  const ReferencePixel pixel = box.paint(rayFrom({-1, 0.3, 0.4}, {1, 0.2, 0.1}));
  EXPECT_EQ(pixel.alpha, 0.0);
  EXPECT_EQ(pixel.light, glm::dvec3(0.0));
}

// A view on which the gradient vanishes counts as seen from the front.
TEST(Classification, OfAVanishingGradientTakesACosineOfOne) {
  PaintedBox box(kuhnGrid(2, 2, 2, glm::dvec3(0), glm::dvec3(1), waveField));
  box.transfer = TransferFunction({{0, {0.5, 1, 0.25}, 1.5}}, "uniform");
  box.appearance.modulations = {modulationBy(ModulatedBy::ViewCosine, {{0, 0, {1, 1, 1}}, {1, 1, {1, 1, 1}}})};
  box.data.modulators.resize(1);
  box.data.gradients.assign(box.mesh.pointCount(), glm::dvec3(0.0));
  const Ray ray = rayFrom({-1, 0.3, 0.4}, {1, 0.2, 0.1});
  const BoxChord chord(ray);
  EXPECT_NEAR(box.paint(ray).alpha, -std::expm1(-1.5 * (chord.back - chord.front) * ray.lengthPerDepth), 1e-13);
}

}  // namespace
}  // namespace tetralux::reference
