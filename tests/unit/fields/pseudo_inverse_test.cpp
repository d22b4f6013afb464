#include "fields/pseudo_inverse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace tetralux {
namespace {

const glm::dvec3 kAxes[] = {glm::dvec3(2, 1, 2) / 3.0, glm::dvec3(-2, 2, 1) / 3.0, glm::dvec3(1, 2, -2) / 3.0};

// With these eigenvalues, along axes oblique to the coordinates.
glm::dmat3 symmetric(double a, double b, double c) {
  return a * glm::outerProduct(kAxes[0], kAxes[0]) + b * glm::outerProduct(kAxes[1], kAxes[1]) +
         c * glm::outerProduct(kAxes[2], kAxes[2]);
}

void expectNear(const glm::dmat3& actual, const glm::dmat3& expected, double tolerance) {
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) EXPECT_NEAR(actual[i][k], expected[i][k], tolerance) << i << " " << k;
  }
}

TEST(PseudoInverse, IsTheInverseOfRegularMatrices) {
  expectNear(pseudoInverse(symmetric(1, 2, 4), 1e-12), symmetric(1, 0.5, 0.25), 1e-15);
  // On both sides of the change from Cramer's rule to eigenvalues.
  for (const double small : {1e-6, 1e-7, 1e-8}) {
    const glm::dmat3 m = symmetric(1, 1, small);
    expectNear(pseudoInverse(m, 1e-12) * small, symmetric(small, small, 1), 1e-8);
  }
  expectNear(pseudoInverse(symmetric(1, 1e-4, 1e-8), 1e-12) * 1e-8, symmetric(1e-8, 1e-4, 1), 1e-7);
}

TEST(PseudoInverse, LeavesOutDirectionsThatTheMatrixDoesNotReach) {
  expectNear(pseudoInverse(symmetric(4, 2, 0), 1e-12), symmetric(0.25, 0.5, 0), 1e-15);
  expectNear(pseudoInverse(symmetric(0, 4, 0), 1e-12), symmetric(0, 0.25, 0), 1e-15);
  expectNear(pseudoInverse(symmetric(4, 2, 1e-13), 1e-12), symmetric(0.25, 0.5, 0), 1e-12);
  expectNear(pseudoInverse(symmetric(4, 1e-13, 1e-14), 1e-12), symmetric(0.25, 0, 0), 1e-12);
  expectNear(pseudoInverse(glm::dmat3(0.0), 1e-12), glm::dmat3(0.0), 0.0);
}

TEST(PseudoInverse, DoesNotDependOnUnits) {
  const glm::dmat3 inverse = pseudoInverse(symmetric(3, 2, 1), 1e-12);
  for (const double unit : {0x1p-400, 0x1p400}) {
    EXPECT_EQ(pseudoInverse(symmetric(3, 2, 1) * unit, 1e-12) * unit, inverse);
  }
}

TEST(PseudoInverse, IsZeroForWhatIsNoNumber) {
  glm::dmat3 matrix(1.0);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    matrix[1][1] = bad;
    EXPECT_EQ(pseudoInverse(matrix, 1e-12), glm::dmat3(0.0));
  }
}

}  // namespace
}  // namespace tetralux
