#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <random>

#include "painted_box.h"
#include "reference/isosurface_crossings.h"
#include "reference/segment_links.h"
#include "support/tilted.h"

namespace tetralux::reference {
namespace {

constexpr int kSide = 4;  // boxes of the grids along an edge

// Values of a field at the planes x = 0, 1/4, ... 1, linear between: what happens to a surface of the value 1 at them.
using Profile = std::array<double, kSide + 1>;
const Profile kRamp = {0, 1, 2, 3, 4};
const Profile kPlateau = {0, 1, 1, 2, 3};         // a layer of cells where s = v
const Profile kTable = {0, 1, 1, 0.5, 0};         // that layer alone is not below
const Profile kTouchedAbove = {2, 1.5, 1, 3, 3};  // the surface touches, and nothing is below
const Profile kTouchedBelow = {0, 0.5, 1, 0, 0};  // the set is a plane
const Profile kValley = {2, 1, 1, 2, 3};
const Profile kZigzag = {0, 2, 0, 2, 0};
const Profile kFlat = {1, 1, 1, 1, 1};
const Profile kBordered = {1, 2, 3, 2, 1};
const Profile kTopped = {1, 0, 0.5, 0.7, 1};

double along(const Profile& profile, double x) {
  const double place = std::clamp(x, 0.0, 1.0) * kSide;
  const auto low = std::min(static_cast<size_t>(place), size_t{kSide - 1});
  return std::lerp(profile[low], profile[low + 1], place - static_cast<double>(low));
}

Isosurface surfaceOf(double value, double opacity = 0.5) {
  Isosurface surface;
  surface.value = value;
  surface.opacity = opacity;
  surface.shading = Shading::None;
  return surface;
}

PaintedBox boxOf(const Profile& profile, const std::vector<double>& values) {
  PaintedBox box(kuhnGrid(kSide, kSide, kSide, glm::dvec3(0), glm::dvec3(1),
                          [&](const glm::dvec3& p) { return along(profile, p.x); }));
  for (const double value : values) box.appearance.isosurfaces.push_back(surfaceOf(value));
  return box;
}

// How often {s >= value} begins or ends along a part of a ray from x = a to x = b. Between planes s is monotone.
std::uint32_t changes(const Profile& profile, double value, double a, double b) {
  std::vector<double> places = {a};
  for (int i = 0; i <= kSide; i++) {
    const double plane = static_cast<double>(a < b ? i : kSide - i) / kSide;
    if (plane > std::min(a, b) && plane < std::max(a, b)) places.push_back(plane);
  }
  places.push_back(b);
  std::uint32_t count = 0;
  for (size_t i = 1; i < places.size(); i++)
    count += (along(profile, places[i - 1]) >= value) != (along(profile, places[i]) >= value) ? 1 : 0;
  return count;
}

// The end of a ray's chord, in a plane exactly where it ends there.
double borderX(const Ray& ray, double depth) {
  const double x = ray.origin.x + depth * ray.direction.x;
  const double plane = std::round(x * kSide) / kSide;
  return std::abs(x - plane) < 1e-12 ? plane : x;
}

// How often a ray through the box crosses the surfaces of these values; nothing where it passes the box by, or where
// rounding decides: at the end of its chord, between planes, s is one of the values.
std::optional<std::uint32_t> expectedCrossings(const Profile& profile, const std::vector<double>& values,
                                               const Ray& ray) {
  const BoxChord chord(ray);
  if (!(chord.front < chord.back - 1e-6)) return {};
  std::uint32_t count = 0;
  for (const double value : values) {
    const std::array<double, 2> ends = {borderX(ray, chord.front), borderX(ray, chord.back)};
    for (const double x : ends) {
      const double place = x * kSide;
      const bool isInPlane = place == std::round(place);
      const auto low = static_cast<size_t>(place);
      if (!isInPlane && profile[low] == profile[low + 1]) continue;
      if (!isInPlane && std::abs(along(profile, x) - value) < 1e-12) return {};
    }
    count += changes(profile, value, ends[0], ends[1]);
  }
  return count;
}

void expectChanges(const PaintedBox& box, const Profile& profile, const std::vector<double>& values, const Ray& ray) {
  const auto expected = expectedCrossings(profile, values, ray);
  if (!expected) return;
  const ReferencePixel pixel = box.paint(ray);
  EXPECT_EQ(pixel.crossings, *expected) << "from " << ray.origin.x << " " << ray.origin.y << " " << ray.origin.z
                                        << " along " << ray.direction.x << " " << ray.direction.y << " "
                                        << ray.direction.z;
  EXPECT_NEAR(pixel.alpha, 1.0 - std::pow(0.5, *expected), 1e-15);
}

const std::vector<Profile> kProfiles = {kRamp,   kPlateau, kTable, kTouchedAbove, kTouchedBelow,
                                        kValley, kZigzag,  kFlat,  kBordered,     kTopped};
const std::vector<double> kValues = {0.0, 0.5, 1.0, 2.0, 2.75};  // most of them at vertices

// The count is that of the closed form for rays through faces, also where surfaces lie in faces, touch, or fill cells.
TEST(Isosurface, IsCrossedOnceWhereverItLies) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const Profile& profile : kProfiles) {
    const PaintedBox box = boxOf(profile, kValues);
    for (int i = 0; i < 400; i++) {
      const glm::dvec3 through(uniform(random), uniform(random), uniform(random));
      const glm::dvec3 direction = glm::dvec3(uniform(random), uniform(random), uniform(random)) - 0.5;
      expectChanges(box, profile, kValues, rayFrom(through - 3.0 * direction, direction));
      expectChanges(box, profile, kValues, rayFrom(through, direction));
    }
  }
}

// Rays through vertices and edges of cells, where each cell has an opinion of its own on where the ray is.
TEST(Isosurface, IsCrossedOnceThroughVerticesAndEdges) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::uniform_int_distribution<int> whole(0, kSide);
  for (const Profile& profile : kProfiles) {
    const PaintedBox box = boxOf(profile, kValues);
    for (int i = 0; i < 400; i++) {
      glm::dvec3 through = glm::dvec3(whole(random), whole(random), whole(random)) / double(kSide);
      if (i % 2 == 1) through[i / 2 % 3] = uniform(random);
      const glm::dvec3 direction = glm::dvec3(uniform(random), uniform(random), uniform(random)) - 0.5;
      expectChanges(box, profile, kValues, rayFrom(through - 3.0 * direction, direction));
      // From vertex to vertex: through more of them on the way.
      const glm::dvec3 other = glm::dvec3(whole(random), whole(random), whole(random)) / double(kSide);
      if (other != through)
        expectChanges(box, profile, kValues, rayFrom(through + 2.0 * (through - other), other - through));
    }
  }
}

// Rays along the axes, in faces and edges.
TEST(Isosurface, IsCrossedOnceInFacesAndEdges) {
  for (const Profile& profile : kProfiles) {
    const PaintedBox box = boxOf(profile, kValues);
    for (int y = 1; y < 2 * kSide; y++) {
      for (int z = 1; z < 2 * kSide; z++) {
        for (const double sign : {1.0, -1.0})
          expectChanges(box, profile, kValues,
                        rayFrom({0.5 - 2.0 * sign, y / (2.0 * kSide), z / (2.0 * kSide)}, {sign, 0.0, 0.0}));
      }
    }
  }
}

// A turned mesh, whose coordinates have all their digits: nothing is exact but the values at vertices.
TEST(Isosurface, IsCrossedOnceInATurnedMesh) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::uniform_int_distribution<int> whole(0, kSide);
  const auto turned = [](const glm::dvec3& p) {
    TetMesh point;
    point.points = std::vector<glm::dvec3>{p};
    return test::tilted(point).point(0);
  };
  for (const Profile& profile : kProfiles) {
    PaintedBox box = boxOf(profile, kValues);
    box.mesh = test::tilted(box.mesh);
    for (int i = 0; i < 600; i++) {
      glm::dvec3 through = glm::dvec3(whole(random), whole(random), whole(random)) / double(kSide);
      if (i % 3 == 1) through[i / 3 % 3] = uniform(random);
      if (i % 3 == 2) through = {uniform(random), uniform(random), uniform(random)};
      const glm::dvec3 direction = glm::dvec3(uniform(random), uniform(random), uniform(random)) - 0.5;
      const Ray straight = rayFrom(through - 3.0 * direction, direction);
      const auto expected = expectedCrossings(profile, kValues, straight);
      if (!expected) continue;
      EXPECT_EQ(box.paint(rayFrom(turned(straight.origin), turned(direction))).crossings, *expected) << i;
    }
  }
}

TEST(Isosurface, EndsTheRayWhereItIsOpaque) {
  PaintedBox box = boxOf(kRamp, {});
  box.appearance.isosurfaces = {surfaceOf(1.0, 0.25), surfaceOf(2.0, 1.0), surfaceOf(3.0, 0.5)};
  box.appearance.isosurfaces[0].rgb = {1, 0, 0};
  box.appearance.isosurfaces[1].rgb = {0, 1, 0};
  box.appearance.isosurfaces[1].backRgb = {0, 0, 1};
  box.appearance.isosurfaces[2].backRgb = {0, 0.5, 0};
  const ReferencePixel rising = box.paint(rayFrom({-1, 0.3, 0.4}, {1, 0.01, 0.02}));
  EXPECT_EQ(rising.crossings, 2u);
  EXPECT_EQ(rising.alpha, 1.0);
  EXPECT_EQ(rising.light, glm::dvec3(0.25, 0.75, 0.0));
  const ReferencePixel falling = box.paint(rayFrom({2, 0.3, 0.4}, {-1, 0.01, 0.02}));
  EXPECT_EQ(falling.crossings, 2u);
  EXPECT_EQ(falling.light, glm::dvec3(0.0, 0.25, 0.5));
}

// Closed form: uniform volume before and behind a surface.
TEST(Isosurface, CutsTheVolume) {
  PaintedBox box = boxOf(kRamp, {});
  box.transfer = TransferFunction({{0, {0.5, 1, 0.25}, 1.5}}, "uniform");
  box.appearance.isosurfaces = {surfaceOf(0.7, 0.6)};
  box.appearance.isosurfaces[0].rgb = {0.1, 0.2, 0.9};
  const Ray ray = rayFrom({-1, 0.3, 0.4}, {1, 0.2, 0.1});
  const BoxChord chord(ray);
  const double before = std::exp(-1.5 * ray.lengthPerDepth * (1.0 + 0.7 / 4 - chord.front));
  const double behind = std::exp(-1.5 * ray.lengthPerDepth * (chord.back - 1.0 - 0.7 / 4));
  const ReferencePixel pixel = box.paint(ray);
  const auto expected = [&](double volume, double surface) {
    return volume * (1.0 - before) + before * (0.6 * surface + 0.4 * volume * (1.0 - behind));
  };
  EXPECT_NEAR(pixel.light.x, expected(0.5, 0.1), 1e-14);
  EXPECT_NEAR(pixel.light.y, expected(1.0, 0.2), 1e-14);
  EXPECT_NEAR(pixel.light.z, expected(0.25, 0.9), 1e-14);
  EXPECT_NEAR(pixel.alpha, 1.0 - 0.4 * before * behind, 1e-14);
}

// Surfaces of no opacity only cut segments: the picture is the volume's.
TEST(Isosurface, WithoutOpacityChangesNothing) {
  PaintedBox box(randomDelaunay(400, 5));
  box.transfer =
      TransferFunction({{0.1, {1, 0, 0}, 1}, {0.5, {0, 1, 0}, 5}, {0.5, {1, 1, 0}, 9}, {0.8, {0, 0, 1}, 2}}, "t");
  for (const double value : {0.2, 0.45, 0.5, 0.81}) box.appearance.isosurfaces.push_back(surfaceOf(value, 0.0));
  box.camera.eye = {2.1, -1.7, 1.3};
  box.camera.center = {0.5, 0.5, 0.5};
  const ImageSize size{24, 24};
  const auto cut = box.render(size);
  const auto whole = renderPixels({box.mesh, box.field, box.transfer, box.camera, size});
  std::uint32_t crossings = 0;
  for (size_t i = 0; i < cut.size(); i++) {
    EXPECT_NEAR(cut[i].alpha, whole[i].alpha, 1e-12);
    for (int c = 0; c < 3; c++) EXPECT_NEAR(cut[i].light[c], whole[i].light[c], 1e-12);
    crossings += cut[i].crossings;
  }
  EXPECT_GT(crossings, 300u);
}

// Gradients that are linear in the place are interpolated exactly on any mesh.
TEST(Isosurface, IsLitByInterpolatedGradients) {
  const auto scalar = [](const glm::dvec3& p) { return 0.3 * p.x + 0.5 * p.y + 0.2 * p.z; };
  const auto gradient = [](const glm::dvec3& p) {
    return glm::dvec3(1.0 + p.x - 0.5 * p.z, 0.3 - p.y, 0.7 * p.z + 0.2 * p.x);
  };
  PaintedBox box(randomDelaunay(300, 6, scalar));
  for (size_t i = 0; i < box.mesh.pointCount(); i++) box.data.gradients.push_back(gradient(box.mesh.point(i)));
  box.appearance.isosurfaces = {surfaceOf(0.45, 1.0)};
  box.appearance.isosurfaces[0].rgb = {0.9, 0.5, 0.1};
  box.appearance.isosurfaces[0].backRgb = {0.2, 0.4, 0.6};
  box.appearance.lighting.lights = {{glm::normalize(glm::dvec3(1, -1, 2)), {0.5, 0.6, 0.7}}};
  for (const Shading shading : {Shading::Phong, Shading::Flat, Shading::None}) {
    Isosurface& surface = box.appearance.isosurfaces[0];
    surface.shading = shading;
    for (const glm::dvec3& eye : {glm::dvec3(-1, -2, -1.5), glm::dvec3(2, 2.5, 3), glm::dvec3(0.1, 0.1, 0.2)}) {
      const glm::dvec3 direction = glm::dvec3(0.52, 0.47, 0.45) - eye;
      const Ray ray = rayFrom(eye, direction);
      const double depth = (0.45 - scalar(eye)) / scalar(direction);
      const glm::dvec3 normal =
          shading == Shading::Phong ? gradient(eye + depth * direction) : glm::dvec3(0.3, 0.5, 0.2);
      const glm::dvec3& rgb = scalar(direction) > 0 ? surface.rgb : surface.backRgb;
      const glm::dvec3 expected =
          shading == Shading::None ? rgb
                                   : illuminate(box.appearance.lighting, normal, -glm::normalize(direction)).lit(rgb);
      const ReferencePixel pixel = box.paint(ray);
      EXPECT_EQ(pixel.crossings, 1u);
      for (int c = 0; c < 3; c++) EXPECT_NEAR(pixel.light[c], expected[c], 1e-9);
    }
  }
}

TEST(IsosurfaceCrossings, ComeInTheOrderOfTheRay) {
  const std::vector<Isosurface> surfaces = {surfaceOf(0), surfaceOf(1), surfaceOf(2), surfaceOf(3)};
  const auto rising = isosurfaceCrossings(surfaces, 0, 2);  // begins on the first: not below it before either
  ASSERT_EQ(rising.size(), 2u);
  EXPECT_EQ(rising[0].surface, &surfaces[1]);
  EXPECT_EQ(rising[0].share, 0.5);
  EXPECT_EQ(rising[1].share, 1.0);
  EXPECT_TRUE(rising[0].isRising);
  const auto falling = isosurfaceCrossings(surfaces, 2, -2);
  ASSERT_EQ(falling.size(), 3u);
  EXPECT_EQ(falling[0].surface, &surfaces[2]);
  EXPECT_EQ(falling[0].share, 0.0);
  EXPECT_EQ(falling[2].share, 0.5);
  EXPECT_FALSE(falling[0].isRising);
  EXPECT_TRUE(isosurfaceCrossings(surfaces, 1, 1).empty());
}

TEST(SegmentLinks, FollowDepthAndScalar) {
  constexpr double kEpsilon = 1e-13;
  // Two layers that overlap, their segments in the order of their middles; a gap in the first.
  const std::vector<CellSegment> segments = {{1.0, 2.0, 0.0, 0.5},
                                             {1.5, 2.0, 8.0, 9.0},
                                             {2.0 + kEpsilon, 2.4, 9.0 + kEpsilon, 7.0},
                                             {2.0 - kEpsilon, 2.5, 0.5 - kEpsilon, 1.0},
                                             {2.6, 3.0, 1.0, 1.5}};
  EXPECT_EQ(predecessors(segments, 1e-9), (std::vector<std::uint32_t>{kNoSegment, kNoSegment, 1, 0, kNoSegment}));
  // Each end goes on once: of three thin segments that all end within the tolerance each follows the one before.
  const std::vector<CellSegment> thin = {{1.0, 2.0, 0.0, 1.0},
                                         {2.0, 2.0 + 2e-10, 1.0, 1.0},
                                         {2.0 + 2e-10, 2.0 + 4e-10, 1.0, 1.0},
                                         {2.0 + 4e-10, 3.0, 1.0, 1.0}};
  EXPECT_EQ(predecessors(thin, 1e-9), (std::vector<std::uint32_t>{kNoSegment, 0, 1, 2}));
}

}  // namespace
}  // namespace tetralux::reference
