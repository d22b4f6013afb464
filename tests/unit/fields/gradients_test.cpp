#include "fields/gradients.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/generate.h"
#include "mesh/mesh_io.h"
#include "support/shared_data.h"
#include "unit/fields/sphere_points.h"

namespace tetralux {
namespace {

using Points = std::vector<glm::dvec3>;

Points pointsOf(const TetMesh& mesh) {
  Points points;
  for (size_t i = 0; i < mesh.pointCount(); i++) points.push_back(mesh.point(i));
  return points;
}

std::vector<double> valuesAt(const TetMesh& mesh, const FieldFunction& field) {
  std::vector<double> values;
  for (size_t i = 0; i < mesh.pointCount(); i++) values.push_back(field(mesh.point(i)));
  return values;
}

std::vector<glm::dvec3> gradientsOf(const TetMesh& mesh, const FieldFunction& field) {
  return GradientFit(mesh).gradients(valuesAt(mesh, field));
}

const glm::dvec3 kSlope(0.3, -2.0, 0.7);

// Relative to the mesh's centre, so that no digits are lost before the fit begins.
FieldFunction linearField(const TetMesh& mesh) {
  return [center = mesh.bounds().center()](const glm::dvec3& p) { return 5.0 + glm::dot(kSlope, p - center); };
}

double largestError(const std::vector<glm::dvec3>& gradients, const glm::dvec3& expected) {
  double largest = 0.0;
  for (const glm::dvec3& g : gradients) largest = std::max(largest, glm::length(g - expected));
  return largest;
}

bool allFinite(const std::vector<glm::dvec3>& gradients) {
  return std::all_of(gradients.begin(), gradients.end(), [](const glm::dvec3& g) {
    return std::isfinite(g.x) && std::isfinite(g.y) && std::isfinite(g.z);
  });
}

TEST(Gradients, AreExactForLinearFields) {
  for (const TetMesh& mesh : {kuhnGrid(5, 6, 7, {-1, 0, 3}, {1, 1, 4}, waveField), randomDelaunay(2000, 1),
                              twistedDelaunay(2000, 1, 2.0), cyclicOctahedron()})
    EXPECT_LT(largestError(gradientsOf(mesh, linearField(mesh)), kSlope), 1e-10);
}

TEST(Gradients, AreExactForLinearFieldsInFlatAndLongCells) {
  for (const double factor : {1e-2, 1e-4}) {
    const TetMesh mesh = flattenedDelaunay(2000, 1, factor);
    EXPECT_LT(largestError(gradientsOf(mesh, linearField(mesh)), kSlope), 1e-5) << factor;
  }
  const TetMesh graded = gradedBox(10, 1e5);
  EXPECT_LT(largestError(gradientsOf(graded, linearField(graded)), kSlope), 1e-5);
}

TEST(Gradients, AreExactForLinearFieldsOnMeshesFromSimulations) {
  struct Case {
    const char* file;
    std::ptrdiff_t flatNeighborhoods;  // vertices all of whose neighbours lie in a plane through them
  };
  for (const Case& c : {Case{"data/spx.vtu", 0}, Case{"data/bluntfin.vtu", 9}, Case{"data/combustor.vtu", 0},
                        Case{"data/oxygenpost.vtu", 0}}) {
    REQUIRE_SHARED(c.file);
    const TetMesh mesh = readMesh(test::sharedPath(c.file));
    const auto gradients = gradientsOf(mesh, linearField(mesh));
    EXPECT_EQ(std::count_if(gradients.begin(), gradients.end(),
                            [](const glm::dvec3& g) { return glm::distance(g, kSlope) > 1e-6; }),
              c.flatNeighborhoods)
        << c.file;
    // What is left out is a part of the gradient, at right angles to the rest.
    for (const glm::dvec3& g : gradients) ASSERT_NEAR(glm::dot(g, g), glm::dot(g, kSlope), 1e-5) << c.file;
  }
}

// What an isosurface's shading needs: within 1 degree at 99 % of the surface.
TEST(Gradients, GiveNormalsOfASphereWithinADegree) {
  const glm::dvec3 low(-1.0);
  const glm::dvec3 high(1.0);
  TetMesh random = randomDelaunay(16000, 1);
  for (glm::dvec3& p : std::get<Points>(random.points)) p = 2.0 * p - 1.0;
  const TetMesh jittered = jitteredGrid(26, 26, 26, low, high, 1.0 / 6.0, 1, waveField);
  const TetMesh jitteredDelaunay = delaunay(pointsOf(jitteredGrid(25, 25, 25, low, high, 0.3, 1, waveField)));
  const glm::dvec3 center(0.01, 0.02, -0.013);
  for (const TetMesh& mesh : {kuhnGrid(26, 26, 26, low, high, waveField), jittered, jitteredDelaunay, random}) {
    const std::vector<double> distances = valuesAt(mesh, [&](const glm::dvec3& p) { return glm::distance(p, center); });
    const auto points = test::spherePoints(mesh, distances, center, 0.5, 4000);
    ASSERT_GE(points.size(), 3990u);
    const std::vector<double> angles = test::anglesToNormals(points, GradientFit(mesh).gradients(distances));
    const double p99 = angles[angles.size() * 99 / 100];
    EXPECT_LT(p99, 1.0);
    EXPECT_LT(angles.back(), 2.0);
  }
}

// A one-sided difference would err by half an edge times the second derivative.
TEST(Gradients, ErrorsOfAQuadraticFieldAreSmallUpToTheBorder) {
  const TetMesh mesh = kuhnGrid(20, 20, 20, {0, 0, 0}, {1, 1, 1}, waveField);
  const auto gradients = gradientsOf(mesh, [](const glm::dvec3& p) { return p.x * p.x - p.y * p.z; });
  constexpr double kOneSided = 0.05;
  for (size_t i = 0; i < mesh.pointCount(); i++) {
    const glm::dvec3 p = mesh.point(i);
    ASSERT_LT(glm::length(gradients[i] - glm::dvec3(2.0 * p.x, -p.z, -p.y)), 0.5 * kOneSided) << i;
  }
}

TEST(Gradients, UnitsAndPlaceDoNotMatter) {
  const TetMesh mesh = randomDelaunay(500, 2);
  const std::vector<double> values = valuesAt(mesh, waveField);
  const std::vector<glm::dvec3> expected = GradientFit(mesh).gradients(values);
  for (const int exponent : {-900, -1, 300, 900}) {
    TetMesh scaled = mesh;
    for (glm::dvec3& p : std::get<Points>(scaled.points)) p *= std::ldexp(1.0, exponent);
    std::vector<double> scaledValues = values;
    for (double& value : scaledValues) value *= std::ldexp(1.0, exponent / 2);
    const auto gradients = GradientFit(scaled).gradients(scaledValues);
    for (size_t i = 0; i < gradients.size(); i++)
      ASSERT_EQ(gradients[i] * std::ldexp(1.0, exponent - exponent / 2), expected[i]) << exponent;
  }
  // Places are multiples of 2^-20 or more of the unit cube, so that moving them loses no digits.
  TetMesh moved = mesh;
  for (glm::dvec3& p : std::get<Points>(moved.points)) p += 4096.0;
  EXPECT_EQ(GradientFit(moved).gradients(values), expected);
}

TEST(Gradients, AreTheSameBitsEveryTime) {
  const TetMesh mesh = randomDelaunay(5000, 3);
  const std::vector<double> values = valuesAt(mesh, waveField);
  EXPECT_EQ(GradientFit(mesh).gradients(values), GradientFit(mesh).gradients(values));
}

TEST(Gradients, LieInThePlaneOfAFlatNeighborhood) {
  TetMesh mesh;
  mesh.points = Points{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {3, 1, 0}, {0.5, 0.25, 0}};
  mesh.cells = {{0, 1, 2, 4}, {1, 2, 3, 4}, {0, 1, 3, 4}};
  for (const auto& g : gradientsOf(mesh, [](const glm::dvec3& p) { return glm::dot(kSlope, p); })) {
    EXPECT_NEAR(g.x, kSlope.x, 1e-12);
    EXPECT_NEAR(g.y, kSlope.y, 1e-12);
    EXPECT_EQ(g.z, 0.0);
  }
}

TEST(Gradients, LieOnTheLineOfAThinNeighborhood) {
  TetMesh mesh;
  mesh.points = Points{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {5, 5, 0}};
  mesh.cells = {{0, 1, 2, 3}};
  for (const auto& g : gradientsOf(mesh, [](const glm::dvec3& p) { return p.x; }))
    EXPECT_LT(glm::length(g - glm::dvec3(0.5, 0.5, 0)), 1e-12);
}

TEST(Gradients, AreZeroWithoutNeighborsAtOtherPlaces) {
  TetMesh mesh;
  mesh.points = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {7, 7, 7}, {8, 8, 8}, {8, 8, 8}};
  mesh.cells = {{0, 1, 2, 3}, {5, 5, 6, 6}, {4, 4, 4, 4}};
  const std::vector<double> values = {0, 1, 2, 3, 4, 5, 6};
  const auto gradients = GradientFit(mesh).gradients(values);
  for (size_t i = 0; i < 4; i++) EXPECT_LT(glm::length(gradients[i] - glm::dvec3(1, 2, 3)), 1e-12);
  for (size_t i = 4; i < 7; i++) EXPECT_EQ(gradients[i], glm::dvec3(0.0));
}

TEST(Gradients, AVertexVeryNearAnotherDoesNotHideOtherDirections) {
  for (const double distance : {1e-3, 1e-6, 1e-12}) {
    TetMesh mesh = kuhnGrid(4, 4, 4, {0, 0, 0}, {1, 1, 1}, waveField);
    auto& points = std::get<Points>(mesh.points);
    const size_t middle = 62;
    points[middle + 1] = points[middle] + distance * glm::dvec3(0.6, 0.0, 0.8);
    EXPECT_LT(largestError(gradientsOf(mesh, linearField(mesh)), kSlope), 1e-3) << distance;
  }
}

TEST(Gradients, AreFiniteForTheLargestAndSmallestNumbers) {
  TetMesh mesh = randomDelaunay(500, 2);
  std::vector<double> values = valuesAt(mesh, waveField);
  std::vector<double> huge;
  std::vector<double> tiny;
  for (size_t i = 0; i < values.size(); i++) {
    huge.push_back(i % 2 == 0 ? 1e308 : -1e308);
    tiny.push_back(5e-324 * static_cast<double>(i));
  }
  TetMesh large = mesh;
  for (glm::dvec3& p : std::get<Points>(large.points)) p *= 1e300;
  EXPECT_TRUE(allFinite(GradientFit(large).gradients(huge)));
  EXPECT_TRUE(allFinite(GradientFit(mesh).gradients(tiny)));
  EXPECT_EQ(GradientFit(large).gradients(std::vector<double>(values.size(), 0.0)),
            std::vector<glm::dvec3>(values.size(), glm::dvec3(0.0)));
}

TEST(Gradients, NoMeshNoGradients) { EXPECT_TRUE(GradientFit(TetMesh()).gradients({}).empty()); }

}  // namespace
}  // namespace tetralux
