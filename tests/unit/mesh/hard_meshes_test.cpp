#include "mesh/hard_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/check.h"
#include "mesh_checks.h"

namespace tetralux {
namespace {

using test::inSteps;
using test::Int128;
using test::interiorsDisjoint;
using test::IntMesh;
using test::IntPoint;
using test::Topology;
using test::topologyOf;

double cellVolume(const TetMesh& mesh, const CellVertices& v) {
  const glm::dvec3 a = mesh.point(v[0]);
  const glm::dvec3 b = mesh.point(v[1]) - a;
  const glm::dvec3 c = mesh.point(v[2]) - a;
  const glm::dvec3 d = mesh.point(v[3]) - a;
  return (b.x * (c.y * d.z - c.z * d.y) + b.y * (c.z * d.x - c.x * d.z) + b.z * (c.x * d.y - c.y * d.x)) / 6.0;
}

size_t invertedCells(const TetMesh& mesh) {
  return static_cast<size_t>(std::count_if(mesh.cells.begin(), mesh.cells.end(),
                                           [&](const CellVertices& cell) { return cellVolume(mesh, cell) <= 0.0; }));
}

double totalVolume(const TetMesh& mesh) {
  double volume = 0.0;
  for (const CellVertices& cell : mesh.cells) volume += cellVolume(mesh, cell);
  return volume;
}

void expectWaveField(const TetMesh& mesh) {
  EXPECT_NO_THROW(validate(mesh, "mesh"));
  EXPECT_EQ(mesh.preferredField, "scalar");
  const ScalarField field = scalarField(mesh, "", "mesh");
  for (size_t i = 0; i < mesh.pointCount(); i++) ASSERT_EQ(field.values[i], waveField(mesh.point(i)));
}

TEST(RandomDelaunay, FillsTheUnitCubeWithTheNumberOfPointsAskedFor) {
  for (const std::uint32_t points : {8u, 9u, 27u, 100u, 2000u}) {
    const TetMesh mesh = randomDelaunay(points, 1);
    EXPECT_EQ(mesh.pointCount(), points);
    const Topology topology = topologyOf(inSteps(mesh, 0x1p-20));
    EXPECT_TRUE(topology.isBall());
    EXPECT_TRUE(topology.volume6 == static_cast<Int128>(6) << 60);
    expectWaveField(mesh);
  }
}

TEST(RandomDelaunay, SidesAreAsDenseAsTheInside) {
  const TetMesh mesh = randomDelaunay(8000, 1);  // 20^3
  size_t onSides = 0;
  for (size_t i = 0; i < mesh.pointCount(); i++) {
    const glm::dvec3 p = mesh.point(i);
    onSides += p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1 || p.z == 0 || p.z == 1;
  }
  EXPECT_EQ(onSides, 8000u - 18 * 18 * 18);
}

TEST(RandomDelaunay, SeedDecidesTheMesh) {
  EXPECT_EQ(randomDelaunay(300, 1).cells, randomDelaunay(300, 1).cells);
  EXPECT_NE(randomDelaunay(300, 1).cells, randomDelaunay(300, 2).cells);
}

TEST(RandomDelaunay, TakesAFieldOfItsOwn) {
  const TetMesh mesh = randomDelaunay(50, 1, [](const glm::dvec3& p) { return p.x; });
  const ScalarField field = scalarField(mesh, "", "mesh");
  for (size_t i = 0; i < mesh.pointCount(); i++) EXPECT_EQ(field.values[i], mesh.point(i).x);
}

TEST(RandomDelaunay, RefusesFewerPointsThanCorners) { EXPECT_THROW(randomDelaunay(7, 1), CheckFailure); }

TEST(FlattenedDelaunay, KeepsTheCellsOfTheCubeAndIsNoLongerDelaunay) {
  constexpr double kFactor = 1.0 / 64.0;
  const TetMesh cube = randomDelaunay(300, 1);
  const TetMesh mesh = flattenedDelaunay(300, 1, kFactor);
  EXPECT_EQ(mesh.cells, cube.cells);
  EXPECT_EQ(mesh.bounds().high, glm::dvec3(1.0, 1.0, kFactor));
  EXPECT_EQ(invertedCells(mesh), 0u);
  EXPECT_NEAR(totalVolume(mesh), kFactor, 1e-12);
  EXPECT_TRUE(isDelaunay(inSteps(cube, 0x1p-20)));
  TetMesh coarse = mesh;  // to whole numbers small enough for the exact test
  for (glm::dvec3& p : std::get<1>(coarse.points))
    p = {std::round(p.x * 0x1p20), std::round(p.y * 0x1p20), std::round(p.z * 0x1p20)};
  EXPECT_FALSE(isDelaunay(inSteps(coarse, 1.0)));
  expectWaveField(mesh);
}

TEST(TwistedDelaunay, HasTheDocumentedNumberOfInvertedCells) {
  // A cell more or less may turn with another machine's sine.
  EXPECT_EQ(invertedCells(twistedDelaunay(1000, 1, 0.0)), 0u);
  EXPECT_NEAR(static_cast<double>(invertedCells(twistedDelaunay(1000, 1, 0.25))), 40.0, 1.0);
  EXPECT_NEAR(static_cast<double>(invertedCells(twistedDelaunay(1000, 1, 0.5))), 71.0, 1.0);
  EXPECT_NEAR(static_cast<double>(invertedCells(twistedDelaunay(1000, 1, 0.75))), 125.0, 1.0);
  EXPECT_NEAR(static_cast<double>(invertedCells(twistedDelaunay(1000, 1, 1.0))), 187.0, 1.0);
}

TEST(TwistedDelaunay, TurnsTheTopAgainstTheBottom) {
  const TetMesh straight = twistedDelaunay(500, 1, 0.0);
  const TetMesh mesh = twistedDelaunay(500, 1, 0.5);
  EXPECT_EQ(mesh.cells, straight.cells);
  EXPECT_EQ(straight.bounds().low, glm::dvec3(-0.5, -0.5, 0.0));
  EXPECT_EQ(straight.bounds().high, glm::dvec3(0.5, 0.5, 3.0));
  for (size_t i = 0; i < mesh.pointCount(); i++) {
    const glm::dvec3 p = straight.point(i);
    const glm::dvec3 q = mesh.point(i);
    EXPECT_EQ(p.z, q.z);
    EXPECT_NEAR(std::hypot(p.x, p.y), std::hypot(q.x, q.y), 1e-15);
    if (p.z == 0.0) {
      EXPECT_EQ(p, q);
    }
    if (p.z == 3.0) {
      EXPECT_NEAR(p.x + q.x, 0.0, 1e-15);
    }
  }
  expectWaveField(mesh);
}

TEST(SliverChain, CellsShareFacesAndFlattenByTheRatio) {
  const TetMesh mesh = sliverChain(40, 0.125);
  ASSERT_EQ(mesh.cellCount(), 40u);
  double before = cellVolume(mesh, mesh.cells[0]);
  EXPECT_GT(before, 0.0);
  for (size_t k = 1; k < mesh.cellCount(); k++) {
    const double volume = cellVolume(mesh, mesh.cells[k]);
    EXPECT_NEAR(volume / before, 0.125, 1e-14);
    before = volume;
    size_t shared = 0;
    for (const std::uint32_t v : mesh.cells[k])
      shared += std::count(mesh.cells[k - 1].begin(), mesh.cells[k - 1].end(), v) > 0;
    EXPECT_EQ(shared, 3u);
  }
  EXPECT_LT(before, 1e-35);
  expectWaveField(mesh);
}

TEST(SliverChain, NoTwoCellsOverlap) {
  const TetMesh mesh = sliverChain(14, 0.5);
  const IntMesh ints = inSteps(mesh, 0x1p-17);
  EXPECT_TRUE(topologyOf(ints).isBall());
  for (size_t i = 0; i < mesh.cellCount(); i++) {
    for (size_t j = 0; j < i; j++) EXPECT_TRUE(interiorsDisjoint(ints.corners(i), ints.corners(j))) << i << ' ' << j;
  }
}

TEST(SliverChain, RefusesARatioOutOfRange) {
  EXPECT_THROW(sliverChain(0, 0.5), CheckFailure);
  EXPECT_THROW(sliverChain(3, 0.0), CheckFailure);
  EXPECT_THROW(sliverChain(3, 1.0), CheckFailure);
}

// A ray with whole-numbered origin and direction, and where it is inside a cell, as exact fractions.
struct Fraction {
  Int128 numerator = 0;
  Int128 denominator = 1;  // > 0

  bool operator<(const Fraction& other) const { return numerator * other.denominator < other.numerator * denominator; }
};

struct Ray {
  IntPoint origin;
  IntPoint direction;
};

struct Segment {
  Fraction entry;
  Fraction exit;
};

std::optional<Segment> segmentInside(const Ray& ray, const std::array<IntPoint, 4>& cell) {
  constexpr size_t kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  Segment segment{{-1'000'000, 1}, {1'000'000, 1}};
  const IntPoint ahead{ray.origin[0] + ray.direction[0], ray.origin[1] + ray.direction[1],
                       ray.origin[2] + ray.direction[2]};
  for (const auto& [a, b, c] : kFaces) {
    // outside is > 0; linear along the ray
    const Int128 atOrigin = test::volume6(cell[a], cell[b], cell[c], ray.origin);
    const Int128 slope = test::volume6(cell[a], cell[b], cell[c], ahead) - atOrigin;
    if (slope == 0) {
      if (atOrigin >= 0) return std::nullopt;
    } else if (slope < 0) {
      segment.entry = std::max(segment.entry, Fraction{atOrigin, -slope});
    } else {
      segment.exit = std::min(segment.exit, Fraction{-atOrigin, slope});
    }
  }
  if (!(segment.entry < segment.exit)) return std::nullopt;
  return segment;
}

// Counts, over rays through a grid of places in the plane z = 0, those that cross `front` before `back`, and those that
// do not. An eye of height 0 means parallel rays along `sense` z.
struct OverlapCount {
  size_t inOrder = 0;
  size_t against = 0;
};
OverlapCount countOverlaps(const std::array<IntPoint, 4>& front, const std::array<IntPoint, 4>& back,
                           std::int64_t eyeHeight, std::int64_t sense) {
  OverlapCount count;
  for (std::int64_t x = -40; x <= 40; x++) {
    for (std::int64_t y = -40; y <= 40; y++) {
      const Ray ray = eyeHeight == 0 ? Ray{{x, y, 0}, {0, 0, sense}} : Ray{{0, 0, eyeHeight}, {x, y, -eyeHeight}};
      const std::optional<Segment> first = segmentInside(ray, front);
      const std::optional<Segment> second = segmentInside(ray, back);
      if (!first || !second) continue;
      (first->exit < second->entry ? count.inOrder : count.against)++;
    }
  }
  return count;
}

TEST(CyclicTriple, ThreeSeparateCellsHideEachOtherInACircle) {
  const IntMesh mesh = inSteps(cyclicTriple(), 1.0 / 16.0);
  ASSERT_EQ(mesh.cells.size(), 3u);
  EXPECT_EQ(topologyOf(mesh).flatOrInverted, 0u);
  EXPECT_EQ(topologyOf(mesh).border.size(), 12u);
  for (size_t k = 0; k < 3; k++) {
    const auto cell = mesh.corners(k);
    const auto next = mesh.corners((k + 1) % 3);
    EXPECT_TRUE(interiorsDisjoint(cell, next));
    for (const std::int64_t eyeHeight : {0, -64, -200, -10000}) {  // parallel, then from below
      const OverlapCount count = countOverlaps(next, cell, eyeHeight, 1);
      EXPECT_GE(count.inOrder, 30u);
      EXPECT_EQ(count.against, 0u);
    }
    for (const std::int64_t eyeHeight : {0, 64, 200, 10000}) {  // from above: the other way round
      const OverlapCount count = countOverlaps(cell, next, eyeHeight, -1);
      EXPECT_GE(count.inOrder, 30u);
      EXPECT_EQ(count.against, 0u);
    }
  }
  expectWaveField(cyclicTriple());
}

TEST(CyclicOctahedron, IsAConvexMeshWithMatchingFaces) {
  const TetMesh mesh = cyclicOctahedron();
  const IntMesh ints = inSteps(mesh, 1.0 / 64.0);
  const Topology topology = topologyOf(ints);
  EXPECT_EQ(mesh.cellCount(), 11u);
  EXPECT_TRUE(topology.isBall());
  EXPECT_EQ(topology.border.size(), 8u);
  EXPECT_TRUE(bordersConvexHull(ints, topology));
  expectWaveField(mesh);
}

// The eye is on one side of the face that two cells share: the cell on that side is in front, on every ray through it.
TEST(CyclicOctahedron, NineCellsHideEachOtherInACircle) {
  const IntMesh mesh = inSteps(cyclicOctahedron(), 1.0 / 64.0);
  constexpr size_t kCycle = 9;
  for (size_t k = 0; k < kCycle; k++) {
    const CellVertices& cell = mesh.cells[k];
    const CellVertices& next = mesh.cells[(k + 1) % kCycle];
    std::vector<IntPoint> face;
    std::optional<IntPoint> apex;
    for (const std::uint32_t v : cell) {
      if (std::count(next.begin(), next.end(), v))
        face.push_back(mesh.points[v]);
      else
        apex = mesh.points[v];
    }
    ASSERT_EQ(face.size(), 3u) << k;
    const auto side = [&](const IntPoint& p) { return test::volume6(face[0], face[1], face[2], p); };
    const bool cellAbovePlane = side(*apex) > 0;
    for (const std::int64_t z : {-1, -64, -1'000'000'000}) EXPECT_EQ(side({0, 0, z}) > 0, cellAbovePlane) << k;
    for (const std::int64_t z : {65, 128, 1'000'000'000}) EXPECT_EQ(side({0, 0, z}) < 0, cellAbovePlane) << k;
    // and one ray through the middle of the face, along +z, with coordinates times three to make the middle whole
    const auto tripled = [](std::array<IntPoint, 4> corners) {
      for (IntPoint& p : corners) p = {3 * p[0], 3 * p[1], 3 * p[2]};
      return corners;
    };
    const Ray ray{{face[0][0] + face[1][0] + face[2][0], face[0][1] + face[1][1] + face[2][1], -1000}, {0, 0, 1}};
    const std::optional<Segment> first = segmentInside(ray, tripled(mesh.corners(k)));
    const std::optional<Segment> second = segmentInside(ray, tripled(mesh.corners((k + 1) % kCycle)));
    ASSERT_TRUE(first && second) << k;
    EXPECT_TRUE(first->entry < second->entry) << k;
    EXPECT_FALSE(second->entry < first->exit) << k;
  }
}

}  // namespace
}  // namespace tetralux
