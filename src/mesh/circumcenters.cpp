#include "mesh/circumcenters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "mesh/vertex_buckets.h"

namespace tetralux {
namespace {

constexpr size_t kGrain = 1 << 14;

template <typename Real>
struct Vector {
  Real x, y, z;

  Vector operator-(const Vector& o) const { return {x - o.x, y - o.y, z - o.z}; }
  Vector operator+(const Vector& o) const { return {x + o.x, y + o.y, z + o.z}; }
  Vector operator*(Real s) const { return {x * s, y * s, z * s}; }
};

template <typename Real>
Vector<Real> widened(const glm::dvec3& p) {
  return {Real(p.x), Real(p.y), Real(p.z)};
}

template <typename Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Real>
Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <typename Real>
Real absolute(Real value) {
  return value < Real(0) ? -value : value;
}

// The determinant of b, c, d with all terms positive: what its rounding error is proportional to.
template <typename Real>
Real permanent(const Vector<Real>& b, const Vector<Real>& c, const Vector<Real>& d) {
  return absolute(b.x) * (absolute(c.y * d.z) + absolute(c.z * d.y)) +
         absolute(b.y) * (absolute(c.z * d.x) + absolute(c.x * d.z)) +
         absolute(b.z) * (absolute(c.x * d.y) + absolute(c.y * d.x));
}

double largestComponent(const glm::dvec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

// Of vertices b, c, d relative to the first, by Cramer's rule for 2 v . x = |v|^2, v = b, c, d. Returns false where the
// determinant is below `share` of its permanent.
template <typename Real>
bool solve(const Vector<Real>& b, const Vector<Real>& c, const Vector<Real>& d, Real share, Vector<Real>& x) {
  const Vector<Real> cd = cross(c, d);
  const Real determinant = dot(b, cd);
  if (absolute(determinant) <= share * permanent(b, c, d)) return false;
  x = (cd * dot(b, b) + cross(d, b) * dot(c, c) + cross(b, c) * dot(d, d)) * (Real(0.5) / determinant);
  return true;
}

}  // namespace

glm::dvec3 circumcenter(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const double largest = std::max({largestComponent(b - a), largestComponent(c - a), largestComponent(d - a)});
  const glm::dvec3 centroid = 0.25 * (b - a) + 0.25 * (c - a) + 0.25 * (d - a);
  if (!(largest > 0.0 && largest < std::numeric_limits<double>::infinity())) return glm::dvec3(0.0);
  // Fourth powers of lengths must neither overflow nor vanish; a power of two rounds nothing.
  const double unit = std::exp2(std::ilogb(largest));
  const auto relative = [&](const glm::dvec3& p) { return (p - a) / unit; };
  constexpr double kDoubleIsEnough = 0x1p-12;
  Vector<double> x;
  if (solve<double>(widened<double>(relative(b)), widened<double>(relative(c)), widened<double>(relative(d)),
                    kDoubleIsEnough, x))
    return unit * glm::dvec3(x.x, x.y, x.z);

  __extension__ using Quadruple = __float128;
  const auto precise = [&](const glm::dvec3& p) {
    return (widened<Quadruple>(p) - widened<Quadruple>(a)) * (Quadruple(1) / Quadruple(unit));
  };
  Vector<Quadruple> wide;
  if (!solve<Quadruple>(precise(b), precise(c), precise(d), Quadruple(8 * 0x1p-113), wide)) return centroid;
  const glm::dvec3 center =
      unit * glm::dvec3(static_cast<double>(wide.x), static_cast<double>(wide.y), static_cast<double>(wide.z));
  return largestComponent(center) < std::numeric_limits<double>::infinity() ? center : centroid;
}

std::vector<glm::dvec3> circumcenters(const TetMesh& mesh) {
  std::vector<glm::dvec3> centers(mesh.cellCount());
  parallelFor(centers.size(), kGrain, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) {
      const CellVertices v = sortedVertices(mesh.cells[i]);
      centers[i] = circumcenter(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]));
    }
  });
  return centers;
}

}  // namespace tetralux
