#include "mesh/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "mesh/random.h"
#include "mesh_checks.h"

namespace tetralux {
namespace {

using test::inSteps;
using test::IntMesh;
using test::Topology;
using test::topologyOf;

constexpr double kUnitStep = 0x1p-20;  // delaunay()'s grid for points that span the unit cube

std::vector<glm::dvec3> randomPoints(size_t count, std::uint64_t seed) {
  std::vector<glm::dvec3> points(count);
  for (size_t i = 0; i < count; i++)
    points[i] = {randomUnit(seed, 3 * i), randomUnit(seed, 3 * i + 1), randomUnit(seed, 3 * i + 2)};
  return points;
}

std::vector<glm::dvec3> latticePoints(int nx, int ny, int nz) {
  std::vector<glm::dvec3> points;
  for (int z = 0; z < nz; z++) {
    for (int y = 0; y < ny; y++) {
      for (int x = 0; x < nx; x++) points.push_back({x, y, z});
    }
  }
  return points;
}

// Cells as places: comparable between meshes whose points are numbered differently.
std::vector<std::array<std::array<double, 3>, 4>> cellPlaces(const TetMesh& mesh) {
  std::vector<std::array<std::array<double, 3>, 4>> result;
  for (const CellVertices& cell : mesh.cells) {
    std::array<std::array<double, 3>, 4> places;
    for (size_t v = 0; v < 4; v++) {
      const glm::dvec3 p = mesh.point(cell[v]);
      places[v] = {p.x, p.y, p.z};
    }
    std::sort(places.begin(), places.end());
    result.push_back(places);
  }
  std::sort(result.begin(), result.end());
  return result;
}

// All that delaunay() promises, exactly.
void expectDelaunayMesh(const TetMesh& mesh, double step, bool checkSpheres = true) {
  EXPECT_NO_THROW(validate(mesh, "mesh"));
  const IntMesh ints = inSteps(mesh, step);
  const Topology topology = topologyOf(ints);
  EXPECT_EQ(topology.flatOrInverted, 0u);
  EXPECT_EQ(topology.mismatched, 0u);
  EXPECT_EQ(topology.eulerNumber, 1);
  EXPECT_EQ(topology.usedPoints, mesh.pointCount());
  EXPECT_TRUE(bordersConvexHull(ints, topology));
  if (checkSpheres) {
    EXPECT_TRUE(isDelaunay(ints));
  }
}

TEST(Delaunay, FourPointsMakeOneCell) {
  const TetMesh mesh = delaunay({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}});  // inverted as given
  EXPECT_EQ(mesh.cellCount(), 1u);
  expectDelaunayMesh(mesh, 1.0);
}

TEST(Delaunay, NoSphereOfRandomPointsHoldsAPoint) {
  for (std::uint64_t seed = 0; seed < 10; seed++) expectDelaunayMesh(delaunay(randomPoints(150, seed)), kUnitStep);
}

TEST(Delaunay, FillsACubeExactly) {
  std::vector<glm::dvec3> points = randomPoints(3000, 1);
  for (const glm::dvec3& corner : latticePoints(2, 2, 2)) points.push_back(corner);
  const TetMesh mesh = delaunay(points);
  EXPECT_EQ(mesh.pointCount(), points.size());
  const Topology topology = topologyOf(inSteps(mesh, kUnitStep));
  EXPECT_TRUE(topology.isBall());
  EXPECT_TRUE(topology.volume6 == static_cast<test::Int128>(6) << 60);
}

TEST(Delaunay, RegularGridOfPointsIsFilledWithPositiveCells) {
  for (const auto& [nx, ny, nz] : {std::array{2, 2, 2}, {3, 3, 3}, {7, 6, 5}, {20, 2, 2}, {9, 9, 9}}) {
    const TetMesh mesh = delaunay(latticePoints(nx, ny, nz));
    expectDelaunayMesh(mesh, 1.0, nx < 9);
    EXPECT_TRUE(topologyOf(inSteps(mesh, 1.0)).volume6 == 6 * (nx - 1) * (ny - 1) * (nz - 1));
  }
}

TEST(Delaunay, AnySubsetOfASmallGridOfPointsIsFilled) {
  for (std::uint64_t seed = 0; seed < 300; seed++) {
    const int edge = 2 + static_cast<int>(seed % 3);
    std::vector<glm::dvec3> points;
    std::uint64_t index = 0;
    for (const glm::dvec3& p : latticePoints(edge, edge, edge)) {
      if (randomUnit(seed, index++) < 0.5) points.push_back(p);
    }
    try {
      expectDelaunayMesh(delaunay(points), 1.0);
    } catch (const CheckFailure&) {
      EXPECT_EQ(edge, 2) << "half of 27 or more points is never flat with these seeds";
    }
    if (HasFailure()) FAIL() << "seed " << seed;
  }
}

TEST(Delaunay, PointsOnASphereAreAllOnTheHull) {
  std::vector<glm::dvec3> points;
  constexpr int kRadiusSquared = 29 * 29;
  for (int x = -29; x <= 29; x++) {
    for (int y = -29; y <= 29; y++) {
      const int z = static_cast<int>(std::lround(std::sqrt(std::max(0, kRadiusSquared - x * x - y * y))));
      if (x * x + y * y + z * z != kRadiusSquared) continue;
      points.push_back({x, y, z});
      if (z > 0) points.push_back({x, y, -z});
    }
  }
  ASSERT_GT(points.size(), 150u);
  const TetMesh mesh = delaunay(points);
  expectDelaunayMesh(mesh, 1.0);
  EXPECT_EQ(topologyOf(inSteps(mesh, 1.0)).border.size(), 2 * points.size() - 4);
}

TEST(Delaunay, PointInTheMiddleOfASphereReplacesAllCells) {
  std::vector<glm::dvec3> points{{5, 0, 0}, {-5, 0, 0}, {0, 5, 0}, {0, -5, 0},
                                 {0, 0, 5}, {0, 0, -5}, {3, 4, 0}, {0, 3, 4}};
  points.push_back({0, 0, 0});
  const TetMesh mesh = delaunay(points);
  expectDelaunayMesh(mesh, 1.0);
  for (const CellVertices& cell : mesh.cells) EXPECT_EQ(std::count(cell.begin(), cell.end(), 8u), 1);
}

TEST(Delaunay, MomentCurveJoinsEveryTwoPoints) {
  constexpr int kPoints = 40;
  std::vector<glm::dvec3> points;
  for (int t = 0; t < kPoints; t++) points.push_back({t, t * t, t * t * t});
  const TetMesh mesh = delaunay(points);
  expectDelaunayMesh(mesh, 1.0);
  EXPECT_GE(mesh.cellCount(), static_cast<size_t>((kPoints - 2) * (kPoints - 3) / 2));
}

TEST(Delaunay, PrismOverACircleHasNoFlatCell) {
  // Points of the circle x^2 + y^2 = 5^2 13^2 17^2 at three heights: circles, spheres and planes full of ties.
  std::vector<glm::dvec3> points;
  constexpr int kRadius = 5 * 13 * 17;
  for (int x = -kRadius; x <= kRadius; x++) {
    const int y = static_cast<int>(std::lround(std::sqrt(kRadius * kRadius - x * x)));
    if (x * x + y * y != kRadius * kRadius) continue;
    for (const int z : {-400, 0, 400}) {
      points.push_back({x, y, z});
      points.push_back({x, -y, z});
    }
  }
  ASSERT_GT(points.size(), 300u);
  expectDelaunayMesh(delaunay(points), 1.0);
}

TEST(Delaunay, ClustersOfAllScalesAreExact) {
  std::vector<glm::dvec3> points = randomPoints(300, 5);
  for (size_t i = 0; i < points.size(); i++) points[i] *= std::exp2(-static_cast<double>(i % 18));
  points.push_back({1, 1, 1});
  expectDelaunayMesh(delaunay(points), kUnitStep);
}

TEST(Delaunay, CoincidentPointsAreDroppedButTheFirst) {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}, {0, 1, 0},
                                       {0, 0, 0}, {0, 0, 1}, {1e-9, 0, 1}};
  const TetMesh mesh = delaunay(points);
  EXPECT_EQ(std::get<1>(mesh.points), (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(mesh.cellCount(), 1u);
}

TEST(Delaunay, ManyDuplicatesLeaveThePlainMesh) {
  std::vector<glm::dvec3> points = latticePoints(4, 4, 4);
  const auto once = cellPlaces(delaunay(points));
  points.insert(points.end(), points.begin(), points.end());
  EXPECT_EQ(cellPlaces(delaunay(points)), once);
}

TEST(Delaunay, OrderOfPointsMakesNoDifference) {
  for (std::vector<glm::dvec3> points : {randomPoints(500, 2), latticePoints(6, 6, 6)}) {
    const auto cells = cellPlaces(delaunay(points));
    std::reverse(points.begin(), points.end());
    EXPECT_EQ(cellPlaces(delaunay(points)), cells);
    for (size_t i = points.size() - 1; i > 0; i--)
      std::swap(points[i], points[static_cast<size_t>(randomUnit(1, i) * static_cast<double>(i))]);
    EXPECT_EQ(cellPlaces(delaunay(points)), cells);
  }
}

TEST(Delaunay, CellsAreSortedAndBeginWithTheirSmallestVertex) {
  const TetMesh mesh = delaunay(randomPoints(500, 3));
  EXPECT_TRUE(std::is_sorted(mesh.cells.begin(), mesh.cells.end()));
  for (const CellVertices& cell : mesh.cells) EXPECT_EQ(cell[0], *std::min_element(cell.begin(), cell.end()));
}

TEST(Delaunay, PointsMoveByLessThanTheGridAndKeepTheirOrder) {
  const std::vector<glm::dvec3> points = randomPoints(1000, 4);
  const TetMesh mesh = delaunay(points);
  ASSERT_EQ(mesh.pointCount(), points.size());
  for (size_t i = 0; i < points.size(); i++) {
    const glm::dvec3 move = mesh.point(i) - points[i];
    for (int axis = 0; axis < 3; axis++) EXPECT_LE(std::abs(move[axis]), 0.5 * kUnitStep);
  }
}

TEST(Delaunay, GridFollowsTheScaleAndThePlaceOfThePoints) {
  for (const double scale : {1e-300, 1e-3, 1.0, 3.0, 1e12, 1e300}) {
    for (const double shift : {0.0, 1.0, -1.0, 1000.0}) {
      std::vector<glm::dvec3> points = randomPoints(200, 6);
      for (glm::dvec3& p : points) p = scale * (p + shift);
      const TetMesh mesh = delaunay(points);
      ASSERT_EQ(mesh.pointCount(), points.size());
      int exponent = 0;
      std::frexp(scale, &exponent);
      // scaled back by a power of two, exactly, to where whole numbers hold the grid
      TetMesh scaled = mesh;
      for (glm::dvec3& p : std::get<1>(scaled.points)) p *= std::ldexp(1.0, -exponent);
      for (glm::dvec3& p : std::get<1>(scaled.points)) p -= std::floor(shift * scale * std::ldexp(1.0, -exponent));
      expectDelaunayMesh(scaled, 0x1p-22);
    }
  }
}

TEST(Delaunay, FarFromTheOriginTheGridFollowsTheSpacingOfDoubles) {
  std::vector<glm::dvec3> points = latticePoints(3, 3, 3);
  for (glm::dvec3& p : points) p += 0x1p52;
  const TetMesh mesh = delaunay(points);  // doubles are 1 apart here
  for (size_t i = 0; i < mesh.pointCount(); i++) EXPECT_EQ(std::fmod(mesh.point(i).x, 4.0), 0.0);
  EXPECT_LT(mesh.pointCount(), points.size());
}

TEST(Delaunay, RefusesPointsThatSpanNoVolume) {
  EXPECT_THROW(delaunay({}), CheckFailure);
  EXPECT_THROW(delaunay({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), CheckFailure);
  EXPECT_THROW(delaunay(std::vector<glm::dvec3>(10, {1, 2, 3})), CheckFailure);
  EXPECT_THROW(delaunay(latticePoints(9, 1, 1)), CheckFailure);
  EXPECT_THROW(delaunay(latticePoints(5, 5, 1)), CheckFailure);
  std::vector<glm::dvec3> tilted;
  for (const glm::dvec3& p : latticePoints(6, 6, 1)) tilted.push_back({p.x, p.y, 2 * p.x - 3 * p.y});
  EXPECT_THROW(delaunay(tilted), CheckFailure);
}

TEST(Delaunay, RefusesCoordinatesThatAreNotFinite) {
  std::vector<glm::dvec3> points = randomPoints(10, 1);
  points[4].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(delaunay(points), CheckFailure);
  points[4].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW(delaunay(points), CheckFailure);
  points[4].y = 1.7e308;
  points[5].y = -1.7e308;  // each is finite, their distance is not
  EXPECT_THROW(delaunay(points), CheckFailure);
}

TEST(SortedAlongCurve, KeepsThePointsAndShortensTheWay) {
  const std::vector<glm::dvec3> points = randomPoints(1000, 8);
  const std::vector<glm::dvec3> sorted = sortedAlongCurve(points);
  const auto wayThrough = [](const std::vector<glm::dvec3>& p) {
    double way = 0.0;
    for (size_t i = 1; i < p.size(); i++)
      way += std::hypot(p[i].x - p[i - 1].x, p[i].y - p[i - 1].y, p[i].z - p[i - 1].z);
    return way;
  };
  EXPECT_TRUE(std::is_permutation(points.begin(), points.end(), sorted.begin()));
  EXPECT_LT(wayThrough(sorted), 0.25 * wayThrough(points));
  EXPECT_TRUE(sortedAlongCurve({}).empty());
}

}  // namespace
}  // namespace tetralux
