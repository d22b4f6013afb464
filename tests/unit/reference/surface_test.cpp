#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "painted_box.h"
#include "reference/surface_tiles.h"

namespace tetralux::reference {
namespace {

constexpr double kPi = 3.14159265358979323846;

// A sphere of triangles, seen anticlockwise from outside: `rings` from pole to pole, twice as many sectors.
OpaqueSurface sphere(int rings, const glm::dvec3& centre, double radius) {
  OpaqueSurface surface;
  const int sectors = 2 * rings;
  surface.points = {centre + glm::dvec3(0, 0, radius), centre - glm::dvec3(0, 0, radius)};
  for (int ring = 1; ring < rings; ring++) {
    for (int sector = 0; sector < sectors; sector++) {
      const double theta = kPi * ring / rings;
      const double phi = 2.0 * kPi * sector / sectors;
      surface.points.push_back(centre + radius * glm::dvec3(std::sin(theta) * std::cos(phi),
                                                            std::sin(theta) * std::sin(phi), std::cos(theta)));
    }
  }
  const auto at = [&](int ring, int sector) {
    return ring == 0       ? 0u
           : ring == rings ? 1u
                           : static_cast<std::uint32_t>(2 + (ring - 1) * sectors + sector % sectors);
  };
  for (int ring = 0; ring < rings; ring++) {
    for (int sector = 0; sector < sectors; sector++) {
      const std::uint32_t a = at(ring, sector), b = at(ring + 1, sector);
      const std::uint32_t c = at(ring + 1, sector + 1), d = at(ring, sector + 1);
      if (ring + 1 < rings) surface.triangles.push_back({a, b, c});
      if (ring > 0) surface.triangles.push_back({a, c, d});
    }
  }
  for (const glm::dvec3& p : surface.points) surface.normals.push_back(p - centre);
  return surface;
}

int triangleCount(const OpaqueSurface& surface, const Ray& ray) {
  const TriangleRay triangleRay(ray);
  int count = 0;
  for (size_t t = 0; t < surface.triangles.size(); t++) {
    TriangleHit hit;
    count += triangleRay.meet(triangleCorners(surface, t), hit) ? 1 : 0;
  }
  return count;
}

// A ray from outside meets a convex polyhedron twice: also through its corners and the middles of its edges, where
// every triangle around has the ray in its border.
TEST(TriangleRay, MeetsAClosedSurfaceTwice) {
  const OpaqueSurface surface = sphere(9, {0.3, 0.2, -0.1}, 0.7);
  std::mt19937 random(31);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 60; i++) {
    glm::dvec3 eye(uniform(random), uniform(random), uniform(random));
    eye = glm::dvec3(0.3, 0.2, -0.1) + 3.0 * glm::normalize(eye);
    if (i % 3 == 0) eye = glm::dvec3(4.0, 0.25, -0.5);
    for (const auto& triangle : surface.triangles) {
      const glm::dvec3 a = surface.points[triangle[0]];
      const glm::dvec3 b = surface.points[triangle[1]];
      for (const glm::dvec3& through : {a, 0.5 * (a + b), (2.0 * a + b) / 3.0}) {
        // A ray that only touches the surface may meet none of it.
        const glm::dvec3 outward = glm::normalize(through - glm::dvec3(0.3, 0.2, -0.1));
        if (glm::dot(outward, glm::normalize(eye - through)) < 0.25) continue;
        EXPECT_EQ(triangleCount(surface, rayFrom(eye, through - eye)), 2);
        EXPECT_EQ(triangleCount(surface, rayFrom(through + 2.0 * (eye - through), 0.37 * (through - eye))), 2);
      }
    }
  }
}

// Along the axes, through corners of a grid: of each plane one triangle.
TEST(TriangleRay, MeetsOneTriangleOfAGrid) {
  OpaqueSurface grid;
  constexpr std::uint32_t kSide = 6;
  for (std::uint32_t y = 0; y <= kSide; y++) {
    for (std::uint32_t x = 0; x <= kSide; x++) grid.points.push_back({0.25 * x, 0.25 * y, 0.125 * ((x * y) % 3)});
  }
  for (std::uint32_t y = 0; y < kSide; y++) {
    for (std::uint32_t x = 0; x < kSide; x++) {
      const std::uint32_t a = x + y * (kSide + 1), b = a + 1, c = a + kSide + 1, d = c + 1;
      grid.triangles.push_back({a, b, d});
      grid.triangles.push_back({a, d, c});
    }
  }
  for (int y = 1; y < 4 * static_cast<int>(kSide); y++) {
    for (int x = 1; x < 4 * static_cast<int>(kSide); x++) {
      for (const double sign : {1.0, -1.0})
        EXPECT_EQ(triangleCount(grid, rayFrom({x / 16.0, y / 16.0, -2.0 * sign}, {0, 0, sign})), 1) << x << " " << y;
    }
  }
}

TEST(TriangleRay, KnowsDepthAndWeights) {
  const std::array<glm::dvec3, 3> corners = {{{0, 2, 0}, {4, 2, 0}, {0, 2, 4}}};
  TriangleHit hit;
  ASSERT_TRUE(TriangleRay(rayFrom({1, 0, 1}, {0, 0.5, 0})).meet(corners, hit));
  EXPECT_NEAR(hit.depth, 4.0, 1e-15);
  EXPECT_NEAR(hit.weights[0], 0.5, 1e-15);
  EXPECT_NEAR(hit.weights[1], 0.25, 1e-15);
  EXPECT_FALSE(TriangleRay(rayFrom({1, 3, 1}, {0, 0.5, 0})).meet(corners, hit));  // behind
  EXPECT_FALSE(TriangleRay(rayFrom({3, 0, 3}, {0, 0.5, 0})).meet(corners, hit));  // beside
  EXPECT_FALSE(TriangleRay(rayFrom({1, 2, 1}, {1, 0, 0.5})).meet(corners, hit));  // in its plane
  EXPECT_FALSE(TriangleRay(rayFrom({1, 0, 1}, {0, 1, 0})).meet({corners[0], corners[1], corners[1]}, hit));
}

struct Ball {
  glm::dvec3 centre{0.1, -0.2, 0.3};
  double radius = 0.8;
  PaintedBox box{kuhnGrid(1, 1, 1, glm::dvec3(20), glm::dvec3(21), waveField)};  // far behind

  Ball() {
    box.appearance.volumeVisible = false;
    box.camera.eye = {2.1, -1.7, 1.3};
    box.camera.center = centre;
    box.camera.fovyDegrees = 40;
  }
};

// No ray passes between the triangles, and each sees the depth of the sphere, up to the triangles' flatness: they are
// nowhere deeper in it than their edges' sagitta.
TEST(Surface, OfASphereIsClosed) {
  Ball ball;
  constexpr int kRings = 60;
  ball.box.data.surfaces = {sphere(kRings, ball.centre, ball.radius)};
  const double inner = ball.radius * std::pow(std::cos(0.5 * kPi / kRings), 2.0);
  const ImageSize size{96, 96};
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    ball.box.camera.projection = projection;
    ball.box.camera.heightWorld = 1.8;
    const auto pixels = ball.box.render(size);
    const SurfaceTiles tiles(ball.box.data.surfaces, ball.box.camera, size);
    // Depth at which a ray enters a sphere, or a negative number.
    const auto enters = [&](const Ray& ray, double radius) {
      const glm::dvec3 p = ray.origin - ball.centre;
      const double b = glm::dot(p, ray.direction) / (ray.lengthPerDepth * ray.lengthPerDepth);
      const double c = (glm::dot(p, p) - radius * radius) / (ray.lengthPerDepth * ray.lengthPerDepth);
      return b * b > c ? -b - std::sqrt(b * b - c) : -1.0;
    };
    int inside = 0;
    for (std::uint32_t i = 0; i < size.width * size.height; i++) {
      const Ray ray = ball.box.camera.pixelRay(size, i % size.width, i / size.width);
      const SurfaceHit hit = tiles.nearest(ray, i % size.width, i / size.width);
      const double first = enters(ray, ball.radius * (1.0 + 1e-14));
      const double last = enters(ray, inner);
      if (first < 0.0) {
        EXPECT_EQ(pixels[i].alpha, 0.0);
        continue;
      }
      if (last < 0.0) continue;  // at the silhouette
      inside++;
      EXPECT_EQ(pixels[i].alpha, 1.0);
      EXPECT_GE(hit.depth, first - 1e-12);
      EXPECT_LE(hit.depth, last + 1e-12);
    }
    EXPECT_GT(inside, 3000);
  }
}

TEST(Surface, IsLitByItsNormalsAndHasTwoSides) {
  Ball ball;
  ball.box.appearance.lighting.lights = {{glm::normalize(glm::dvec3(1, -1, 2)), {0.5, 0.6, 0.7}}};
  OpaqueSurface surface;
  surface.points = {{-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}};
  surface.normals = {{0.2, -1, 0}, {0, -3, 1}, {1, -1, 0.4}};
  surface.rgb = {0.9, 0.5, 0.1};
  surface.backRgb = {0.2, 0.4, 0.6};
  ball.box.camera.eye = {-0.3, -3, -0.4};
  ball.box.camera.center = {-0.3, 0, -0.4};
  const Ray ray = ball.box.camera.pixelRay({1, 1}, 0, 0);
  const std::array<double, 3> weights = {0.35, 0.35, 0.3};
  glm::dvec3 smooth(0.0);
  for (size_t i = 0; i < 3; i++) smooth += weights[i] * surface.normals[i];
  for (const Shading shading : {Shading::None, Shading::Flat, Shading::Phong}) {
    for (const bool isTurned : {false, true}) {
      surface.shading = shading;
      // Anticlockwise from -y: x to the right, z up.
      surface.triangles = {{0, 1, 2}};
      if (isTurned) {
        surface.triangles = {{0, 2, 1}};
      }
      ball.box.data.surfaces = {surface};
      const glm::dvec3& rgb = isTurned ? surface.backRgb : surface.rgb;
      const glm::dvec3 expected =
          shading == Shading::None ? rgb
                                   : illuminate(ball.box.appearance.lighting,
                                                shading == Shading::Flat ? glm::dvec3(0, 1, 0) : smooth, -ray.direction)
                                         .lit(rgb);
      const ReferencePixel pixel = ball.box.render({1, 1})[0];
      for (int c = 0; c < 3; c++) EXPECT_NEAR(pixel.light[c], expected[c], 1e-13);
      EXPECT_EQ(pixel.alpha, 1.0);
    }
  }
}

// A plane through a uniform box: the volume in front of it, and its colour behind. Clip planes leave it whole.
TEST(Surface, EndsTheVolume) {
  PaintedBox box(jitteredGrid(3, 4, 2, glm::dvec3(0), glm::dvec3(1), 0.1, 5, waveField));
  box.transfer = TransferFunction({{0, {0.5, 1, 0.25}, 1.5}}, "uniform");
  box.camera.center = {0.5, 0.5, 0.5};
  box.camera.fovyDegrees = 50;
  OpaqueSurface plane;  // x + 0.5 y = 0.7
  plane.points = {{0.7 + 25, -50, -50}, {0.7 + 25, -50, 150}, {0.7 - 50, 100, 0}};
  plane.triangles = {{0, 1, 2}};
  plane.rgb = plane.backRgb = {0.1, 0.2, 0.9};
  plane.shading = Shading::None;
  box.data.surfaces = {plane};
  const glm::dvec3 normal(1, 0.5, 0);
  const ImageSize size{31, 31};
  for (const bool isClipped : {false, true}) {
    if (isClipped) box.appearance.clip = {{{0, 0, 1}, 0.4}};
    for (const glm::dvec3& eye : {glm::dvec3(2.1, -1.7, 1.3), glm::dvec3(-0.9, -0.7, 0.3), glm::dvec3(0.3, 0.3, 0.6)}) {
      box.camera.eye = eye;
      const auto pixels = box.render(size);
      for (std::uint32_t i = 0; i < size.width * size.height; i++) {
        const Ray ray = box.camera.pixelRay(size, i % size.width, i / size.width);
        const BoxChord chord(ray);
        double front = chord.front;
        double back = chord.back;
        if (isClipped) {
          const double z = (0.4 - ray.origin.z) / ray.direction.z;
          (ray.direction.z > 0 ? front : back) = ray.direction.z > 0 ? std::max(front, z) : std::min(back, z);
        }
        const double depth = (0.7 - glm::dot(normal, ray.origin)) / glm::dot(normal, ray.direction);
        const bool isHit = depth > 0.0;
        if (isHit && glm::length(ray.origin + depth * ray.direction) > 15.0) continue;  // perhaps beside the triangle
        if (isHit) back = std::min(back, depth);
        const double alpha = -std::expm1(-1.5 * std::max(0.0, back - front) * ray.lengthPerDepth);
        EXPECT_NEAR(pixels[i].alpha, isHit ? 1.0 : alpha, 1e-12);
        EXPECT_NEAR(pixels[i].light.z, 0.25 * alpha + (isHit ? 0.9 * (1.0 - alpha) : 0.0), 1e-12);
      }
    }
  }
}

// Isosurfaces behind a surface are hidden, also one that lies in it; opaque ones in front of it hide it.
TEST(Surface, HidesIsosurfacesBehindIt) {
  PaintedBox box(kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), [](const glm::dvec3& p) { return p.x; }));
  OpaqueSurface plane;
  plane.points = {{0.5, -9, -9}, {0.5, 9, -9}, {0.5, 0, 30}};
  plane.triangles = {{0, 1, 2}};
  plane.rgb = plane.backRgb = {0, 0, 1};
  plane.shading = Shading::None;
  box.data.surfaces = {plane};
  box.camera.eye = {2.0, 0.4, 0.3};
  box.camera.center = {0.5, 0.45, 0.55};
  Isosurface surface;
  surface.shading = Shading::None;
  surface.opacity = 0.5;
  for (const auto& [value, isSeen] : {std::pair(0.25, false), std::pair(0.49, false), std::pair(0.625, true)}) {
    surface.value = value;
    box.appearance.isosurfaces = {surface};
    const ReferencePixel pixel = box.render({1, 1})[0];
    EXPECT_EQ(pixel.crossings, isSeen ? 1u : 0u) << value;
    EXPECT_EQ(pixel.light, isSeen ? glm::dvec3(0.5, 0.5, 1.0) : glm::dvec3(0, 0, 1));
    EXPECT_EQ(pixel.alpha, 1.0);
  }
  box.appearance.isosurfaces[0].opacity = 1.0;
  EXPECT_EQ(box.render({1, 1})[0].light, glm::dvec3(1.0));
}

}  // namespace
}  // namespace tetralux::reference
