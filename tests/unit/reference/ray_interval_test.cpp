#include "reference/ray_interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "painted_box.h"

namespace tetralux::reference {
namespace {

TEST(KeptRange, IsTheIntersectionOfHalfSpaces) {
  const Ray ray = rayFrom({0, 0, 0}, {0, 2, 1});
  EXPECT_EQ(keptRange({}, ray).low, -std::numeric_limits<double>::infinity());
  const DepthRange range = keptRange({{{0, 1, 0}, 1.0}, {{0, 0, -3}, -6.0}, {{0, 5, 0}, 2.0}, {{1, 0, 0}, -1.0}}, ray);
  EXPECT_EQ(range.low, 0.5);
  EXPECT_EQ(range.high, 2.0);
  const DepthRange none = keptRange({{{1, 0, 0}, 0.25}}, ray);  // beside the ray
  EXPECT_FALSE(none.low < none.high);
}

TEST(KeptRange, KeepsARayInThePlane) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 1000; i++) {
    const glm::dvec3 normal(uniform(random), uniform(random), uniform(random));
    const glm::dvec3 other(uniform(random), uniform(random), uniform(random));
    const Ray ray = rayFrom(other, glm::cross(normal, glm::dvec3(uniform(random), uniform(random), uniform(random))));
    for (const double sign : {1.0, -1.0}) {
      const DepthRange range = keptRange({{sign * normal, sign * glm::dot(normal, other)}}, ray);
      EXPECT_EQ(range.low, -std::numeric_limits<double>::infinity());
      EXPECT_EQ(range.high, std::numeric_limits<double>::infinity());
    }
  }
}

TEST(CutChord, InterpolatesAndSnaps) {
  const CellChord whole{{2.0, 4.0, 1.0, 3.0}, {1, 0, 0, 0}, {0, 0.5, 0.5, 0}};
  CellChord chord = whole;
  ASSERT_TRUE(cutChord(chord, {2.5, 3.5}));
  EXPECT_EQ(chord.segment.front, 2.5);
  EXPECT_EQ(chord.segment.back, 3.5);
  EXPECT_EQ(chord.segment.sFront, 1.5);
  EXPECT_EQ(chord.segment.sBack, 2.5);
  EXPECT_EQ(chord.weightsFront, (std::array<double, 4>{0.75, 0.125, 0.125, 0}));
  EXPECT_EQ(chord.weightsBack, (std::array<double, 4>{0.25, 0.375, 0.375, 0}));
  chord = whole;
  ASSERT_TRUE(cutChord(chord, {2.0 + 1e-15, 4.0 - 1e-15}));
  EXPECT_EQ(chord.segment.front, 2.0);
  EXPECT_EQ(chord.segment.sBack, 3.0);
  for (const DepthRange& range : {DepthRange{4.0 - 1e-15, 9.0}, {0.0, 2.0 + 1e-15}, {3.0, 3.0}, {5.0, 1.0}})
    EXPECT_FALSE(cutChord(chord, range)) << range.low;
}

// A uniform box: c (1 - exp(-tau d)), d the length of what planes leave of the pixel's ray in the box.
TEST(Clip, OfAUniformBoxIsTheClosedForm) {
  PaintedBox box(jitteredGrid(3, 4, 2, glm::dvec3(0), glm::dvec3(1), 0.1, 5, waveField));
  box.transfer = TransferFunction({{0, {0.5, 1, 0.25}, 1.5}}, "uniform");
  box.appearance.clip = {{{1, 2, 0.5}, 0.9}, {{-1, 0, 0}, -0.8}};
  box.camera.fovyDegrees = 50;
  box.camera.center = {0.52, 0.47, 0.51};
  const ImageSize size{37, 29};
  for (const glm::dvec3& eye : {glm::dvec3(2.1, -1.7, 1.3), glm::dvec3(0.4, 0.3, 0.6)}) {
    box.camera.eye = eye;
    const auto pixels = box.render(size);
    for (std::uint32_t i = 0; i < size.width * size.height; i++) {
      const Ray ray = box.camera.pixelRay(size, i % size.width, i / size.width);
      BoxChord chord(ray);
      const double x = (0.8 - ray.origin.x) / ray.direction.x;  // keeps x <= 0.8
      (ray.direction.x > 0 ? chord.back : chord.front) =
          ray.direction.x > 0 ? std::min(chord.back, x) : std::max(chord.front, x);
      const glm::dvec3 normal(1, 2, 0.5);
      const double slope = glm::dot(normal, ray.direction);
      const double t = (0.9 - glm::dot(normal, ray.origin)) / slope;
      (slope > 0 ? chord.front : chord.back) = slope > 0 ? std::max(chord.front, t) : std::min(chord.back, t);
      const double length = std::max(0.0, chord.back - chord.front) * ray.lengthPerDepth;
      EXPECT_NEAR(pixels[i].alpha, 1.0 - std::exp(-1.5 * length), 1e-12);
      EXPECT_EQ(pixels[i].layers > 0, length > 0.0);
    }
  }
}

// Where the plane is made of faces, the clipped box is the picture of the cells that are left.
TEST(Clip, AlongFacesLeavesWholeCells) {
  const auto scalar = [](const glm::dvec3& p) { return 0.3 * p.x + p.y * p.z; };
  PaintedBox box(kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), scalar));
  PaintedBox half(kuhnGrid(2, 4, 4, glm::dvec3(0.5, 0, 0), glm::dvec3(1), scalar));
  for (PaintedBox* b : {&box, &half}) {
    b->transfer = TransferFunction({{0.1, {1, 0, 0}, 1}, {0.5, {0, 1, 0}, 5}, {0.8, {0, 0, 1}, 2}}, "t");
    b->camera.eye = {2.1, -1.7, 1.3};
    b->camera.center = {0.52, 0.47, 0.51};
  }
  box.appearance.clip = {{{2, 0, 0}, 1.0}};
  const ImageSize size{32, 32};
  for (const glm::dvec3& eye : {glm::dvec3(2.1, -1.7, 1.3), glm::dvec3(-1.1, -1.2, 0.8)}) {
    box.camera.eye = half.camera.eye = eye;
    const auto a = box.render(size);
    const auto b = half.render(size);
    for (size_t i = 0; i < a.size(); i++) {
      EXPECT_EQ(a[i].layers, b[i].layers);
      for (int c = 0; c < 3; c++) EXPECT_NEAR(a[i].light[c], b[i].light[c], 1e-13);
    }
  }
}

// What the rule of the crossing says at the ends of a clipped segment: s = v belongs to the side that is not below.
TEST(Clip, InASurfaceShowsItOnlyFromBelow) {
  PaintedBox box(kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), [](const glm::dvec3& p) { return p.x; }));
  Isosurface surface;
  surface.shading = Shading::None;
  surface.opacity = 0.5;
  surface.value = 0.5;  // in faces of cells
  box.appearance.isosurfaces = {surface};
  for (const double sign : {1.0, -1.0}) {
    box.appearance.clip = {{{sign, 0, 0}, sign * 0.5}};
    for (const double y : {0.3, 0.45, 0.5, 0.125}) {
      for (const double along : {1.0, -1.0}) {
        const Ray ray = rayFrom({0.5 - 2.0 * along, y, 0.4}, {along, 0.0625, 0.03125});
        EXPECT_EQ(box.paint(ray).crossings, sign < 0.0 ? 1u : 0u) << sign << " " << along;
      }
    }
  }
}

}  // namespace
}  // namespace tetralux::reference
