#include "fields/pseudo_inverse.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace tetralux {
namespace {

// Turns the plane of axes p and q so that a[p][q] becomes 0, and the axes, the columns of v, with it (Golub and Van
// Loan 2013, section 8.5.2).
void rotate(glm::dmat3& a, glm::dmat3& v, int p, int q) {
  if (a[p][q] == 0.0) return;
  const double tau = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
  const double t = std::copysign(1.0, tau) / (std::abs(tau) + std::hypot(1.0, tau));
  const double c = 1.0 / std::hypot(1.0, t);
  const double s = t * c;
  for (int k = 0; k < 3; k++) {
    const double kp = a[k][p];
    const double kq = a[k][q];
    a[k][p] = c * kp - s * kq;
    a[k][q] = s * kp + c * kq;
  }
  for (int k = 0; k < 3; k++) {
    const double pk = a[p][k];
    const double qk = a[q][k];
    a[p][k] = c * pk - s * qk;
    a[q][k] = s * pk + c * qk;
  }
  const glm::dvec3 axis = v[p];
  v[p] = c * axis - s * v[q];
  v[q] = s * axis + c * v[q];
}

}  // namespace

glm::dmat3 pseudoInverse(const glm::dmat3& symmetric, double relativeRank) {
  glm::dmat3 result(0.0);
  const double trace = symmetric[0][0] + symmetric[1][1] + symmetric[2][2];
  if (!(trace > 0.0) || !std::isfinite(trace)) return result;
  glm::dmat3 a = symmetric / trace;  // no product of its elements overflows
  // Smallest eigenvalue / largest >= determinant / trace^3: where that is large enough, Cramer's rule loses no more
  // than half of the digits.
  constexpr double kWellConditioned = 1e-7;
  if (glm::determinant(a) > std::max(kWellConditioned, relativeRank)) return glm::inverse(a) / trace;

  glm::dmat3 axes(1.0);
  constexpr int kSweeps = 6;  // convergence is quadratic: 4 leave nothing of a 3 x 3 matrix in double precision
  for (int sweep = 0; sweep < kSweeps; sweep++) {
    rotate(a, axes, 0, 1);
    rotate(a, axes, 0, 2);
    rotate(a, axes, 1, 2);
  }
  const double largest = std::max({a[0][0], a[1][1], a[2][2]});
  for (int k = 0; k < 3; k++) {
    if (a[k][k] > relativeRank * largest) result += glm::outerProduct(axes[k], axes[k]) / (a[k][k] * trace);
  }
  return result;
}

}  // namespace tetralux
