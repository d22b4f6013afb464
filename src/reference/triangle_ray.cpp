#include "reference/triangle_ray.h"

#include <cmath>

namespace tetralux::reference {
namespace {

// p x q with a relative error below 2^-51, so its sign is exact and it is zero only where that is (Kahan's difference
// of products; Jeannerod, Louvet and Muller 2013, theorem 1).
double cross(const glm::dvec2& p, const glm::dvec2& q) {
  const double product = p.y * q.x;
  const double rounding = std::fma(p.y, q.x, -product);
  return std::fma(p.x, q.y, -product) - rounding;
}

// The sign of p x q as seen from (e, e^2) instead of the origin, e tending to zero; 0 for p = q.
int side(const glm::dvec2& p, const glm::dvec2& q, double crossed) {
  if (crossed != 0.0) return crossed > 0.0 ? 1 : -1;
  if (p.y != q.y) return p.y > q.y ? 1 : -1;
  if (p.x != q.x) return p.x < q.x ? 1 : -1;
  return 0;
}

}  // namespace

TriangleRay::TriangleRay(const Ray& ray) : origin_(ray.origin), axis_(0), direction_(ray.direction) {
  for (int i = 1; i < 3; i++) {
    if (std::abs(direction_[i]) > std::abs(direction_[axis_])) axis_ = i;
  }
}

TriangleRay::Corner TriangleRay::sheared(const glm::dvec3& corner) const {
  const int u = (axis_ + 1) % 3;
  const int v = (axis_ + 2) % 3;
  const glm::dvec3 p = corner - origin_;
  const double depth = p[axis_] / direction_[axis_];
  return {{p[u] - direction_[u] * depth, p[v] - direction_[v] * depth}, p[axis_]};
}

bool TriangleRay::meet(const std::array<glm::dvec3, 3>& corners, TriangleHit& hit) const {
  const std::array<Corner, 3> c = {sheared(corners[0]), sheared(corners[1]), sheared(corners[2])};
  std::array<double, 3> weights;  // of the corner opposite the edge
  int sides = 0;
  for (size_t i = 0; i < 3; i++) {
    const glm::dvec2& p = c[(i + 1) % 3].place;
    const glm::dvec2& q = c[(i + 2) % 3].place;
    weights[i] = cross(p, q);
    sides += side(p, q, weights[i]);
  }
  if (sides != 3 && sides != -3) return false;
  const double sum = weights[0] + weights[1] + weights[2];
  if (sum == 0.0) return false;  // underflow
  double along = 0.0;
  for (size_t i = 0; i < 3; i++) {
    hit.weights[i] = weights[i] / sum;
    along += hit.weights[i] * c[i].along;
  }
  hit.depth = along / direction_[axis_];
  return hit.depth > 0.0;
}

}  // namespace tetralux::reference
