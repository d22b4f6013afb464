#include "mesh/orbital.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/check.h"
#include "mesh/random.h"
#include "mesh_checks.h"

namespace tetralux {
namespace {

double length(const glm::dvec3& v) { return std::hypot(v.x, v.y, v.z); }

glm::dvec3 randomPlace(std::uint64_t index) {
  return kOrbitalRadius *
         (2.0 * glm::dvec3(randomUnit(9, 3 * index), randomUnit(9, 3 * index + 1), randomUnit(9, 3 * index + 2)) - 1.0);
}

// In atomic units: -1/2 laplacian psi - psi / r = E psi, with E = -1 / (2 n^2) = -1/32 for n = 4.
TEST(Orbital, SolvesTheSchroedingerEquationOfItsEnergy) {
  constexpr double kStep = 1e-3;
  for (std::uint64_t i = 0; i < 1000; i++) {
    const glm::dvec3 p = randomPlace(i);
    const double psi = orbital4dz2(p);
    double laplacian = 0.0;
    for (int axis = 0; axis < 3; axis++) {
      glm::dvec3 step(0.0);
      step[axis] = kStep;
      laplacian += (orbital4dz2(p + step) - 2.0 * psi + orbital4dz2(p - step)) / (kStep * kStep);
    }
    // rounding: 6 * 2^-53 / step^2 = 7e-10
    EXPECT_NEAR(-0.5 * laplacian - psi / length(p), -psi / 32.0, 1e-7);
  }
}

TEST(Orbital, LargestMagnitudeIsOneAtItsTwoMaxima) {
  const double r = 12.0 - 4.0 * std::sqrt(3.0);
  EXPECT_DOUBLE_EQ(orbital4dz2({0, 0, r}), 1.0);
  EXPECT_DOUBLE_EQ(orbital4dz2({0, 0, -r}), 1.0);
  for (std::uint64_t i = 0; i < 100000; i++) ASSERT_LT(std::abs(orbital4dz2(randomPlace(i) / 4.0)), 1.0);
  EXPECT_LT(orbital4dz2({0, 0, 12.0 + 4.0 * std::sqrt(3.0)}), -0.43);
}

TEST(Orbital, HasItsNodes) {
  EXPECT_EQ(orbital4dz2({0, 0, 0}), 0.0);
  EXPECT_EQ(orbital4dz2({0, 12, 0}), 0.0);
  EXPECT_NEAR(orbital4dz2({1.0, 1.0, 1.0}), 0.0, 1e-15);  // the cone z^2 = (x^2 + y^2) / 2
}

TEST(Orbital, HasDecayedAtTheBorder) {
  EXPECT_LT(std::pow(orbital4dz2({0, 0, kOrbitalRadius}), 2.0), 3.1e-4);
  EXPECT_LT(std::pow(orbital4dz2({0, 0, kOrbitalRadius + 5.0}), 2.0), 1e-4);
}

TEST(HydrogenOrbital, MeetsTheNumberOfCells) {
  for (const std::uint64_t cells : {1000u, 1500u, 2300u, 5000u, 20000u, 250000u}) {
    for (std::uint32_t seed = 0; seed < (cells > 100000 ? 1u : 3u); seed++) {
      const double met = static_cast<double>(hydrogenOrbital(cells, seed).cellCount()) / static_cast<double>(cells);
      EXPECT_NEAR(met, 1.0, 0.1) << cells << " cells, seed " << seed;
    }
  }
}

TEST(HydrogenOrbital, FieldsAreTheWaveFunctionAndItsSquare) {
  const TetMesh mesh = hydrogenOrbital(5000, 1);
  EXPECT_NO_THROW(validate(mesh, "orbital"));
  EXPECT_EQ(mesh.preferredField, "psi");
  const ScalarField psi = scalarField(mesh, "psi", "orbital");
  const ScalarField density = scalarField(mesh, "density", "orbital");
  for (size_t i = 0; i < mesh.pointCount(); i++) {
    ASSERT_EQ(psi.values[i], orbital4dz2(mesh.point(i)));
    ASSERT_EQ(density.values[i], psi.values[i] * psi.values[i]);
  }
  EXPECT_GT(psi.high, 0.8);
  EXPECT_LE(psi.high, 1.0);
}

TEST(HydrogenOrbital, IsARoundBallOfPositiveMatchingCells) {
  for (const std::uint64_t cells : {1000u, 20000u}) {
    const TetMesh mesh = hydrogenOrbital(cells, 2);
    const test::IntMesh ints = test::inSteps(mesh, 0x1p-20);  // of 45 * 2 units in 2^20 steps: finer than its grid
    const test::Topology topology = test::topologyOf(ints);
    EXPECT_TRUE(topology.isBall());
    EXPECT_EQ(topology.usedPoints, mesh.pointCount());
    for (const auto& face : topology.border) {
      for (const std::uint32_t vertex : face) EXPECT_NEAR(length(mesh.point(vertex)), kOrbitalRadius, 1e-4);
    }
  }
}

TEST(HydrogenOrbital, HasThePointOfTheNucleusAndEdgesFourTimesAsLongAtTheBorder) {
  const TetMesh mesh = hydrogenOrbital(50000, 1);
  double innerSum = 0.0, outerSum = 0.0;
  size_t inner = 0, outer = 0;
  bool nucleus = false;
  for (size_t i = 0; i < mesh.pointCount(); i++) nucleus = nucleus || mesh.point(i) == glm::dvec3(0.0);
  for (const CellVertices& cell : mesh.cells) {
    const double r = length(mesh.point(cell[0]));
    const double edge = length(mesh.point(cell[1]) - mesh.point(cell[0]));
    if (r < 3.0) innerSum += edge, inner++;
    if (r > 40.0) outerSum += edge, outer++;
  }
  EXPECT_TRUE(nucleus);
  const double ratio = outerSum / static_cast<double>(outer) / (innerSum / static_cast<double>(inner));
  EXPECT_GT(ratio, 2.5);
  EXPECT_LT(ratio, 4.0);
}

// The smallest angle between two faces, from their outer normals.
double smallestDihedralDegrees(const TetMesh& mesh, const CellVertices& v) {
  std::array<glm::dvec3, 4> normals;
  for (size_t i = 0; i < 4; i++) {
    const glm::dvec3 a = mesh.point(v[(i + 1) & 3]);
    const glm::dvec3 normal = glm::cross(mesh.point(v[(i + 2) & 3]) - a, mesh.point(v[(i + 3) & 3]) - a);
    const double side = glm::dot(normal, mesh.point(v[i]) - a);
    normals[i] = glm::normalize(side < 0.0 ? normal : -normal);
  }
  double largestCosine = -1.0;
  for (size_t i = 0; i < 4; i++) {
    for (size_t j = 0; j < i; j++) largestCosine = std::max(largestCosine, -glm::dot(normals[i], normals[j]));
  }
  return std::acos(std::min(1.0, largestCosine)) * 180.0 / std::numbers::pi;
}

TEST(HydrogenOrbital, HasFewSlivers) {
  const TetMesh mesh = hydrogenOrbital(50000, 1);
  const auto slivers = std::count_if(mesh.cells.begin(), mesh.cells.end(), [&](const CellVertices& cell) {
    return smallestDihedralDegrees(mesh, cell) < 5.0;
  });
  EXPECT_LT(static_cast<double>(slivers), 0.003 * static_cast<double>(mesh.cellCount()));
}

TEST(HydrogenOrbital, SeedDecidesTheMesh) {
  EXPECT_EQ(hydrogenOrbital(2000, 1).cells, hydrogenOrbital(2000, 1).cells);
  EXPECT_NE(hydrogenOrbital(2000, 1).cells, hydrogenOrbital(2000, 2).cells);
}

TEST(HydrogenOrbital, RefusesTooFewCells) { EXPECT_THROW(hydrogenOrbital(999, 1), CheckFailure); }

}  // namespace
}  // namespace tetralux
