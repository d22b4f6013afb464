#include "mesh/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/parallel.h"
#include "mesh/random.h"

namespace tetralux {
namespace {

// Coordinates of the grid's planes along one axis, ascending.
using Axis = std::vector<double>;

// Corner b of a box lies at the upper end of axis a where bit a of b is set. A path from corner 0 to corner 7 along
// the axes in one of the six orders makes one tetrahedron (Kuhn 1960, "Some combinatorial lemmas in topology"). The
// cut of every side is the diagonal from its lowest to its highest corner, seen from both boxes, so neighbours match.
// In the odd orders the middle corners are swapped, which makes the volume positive.
constexpr std::uint8_t kBoxCells[6][4] = {
    {0, 1, 3, 7},  // x y z
    {0, 2, 6, 7},  // y z x
    {0, 4, 5, 7},  // z x y
    {0, 5, 1, 7},  // x z y
    {0, 3, 2, 7},  // y x z
    {0, 6, 4, 7},  // z y x
};

TetMesh gridOnAxes(const Axis& x, const Axis& y, const Axis& z) {
  const size_t nx = x.size() - 1;
  const size_t ny = y.size() - 1;
  const size_t nz = z.size() - 1;
  const size_t row = x.size();
  const size_t layer = row * y.size();
  CHECK_LE(layer, std::numeric_limits<std::uint32_t>::max() / z.size());

  std::vector<glm::dvec3> points(layer * z.size());
  parallelFor(z.size(), 1, [&](size_t begin, size_t end, unsigned) {
    for (size_t k = begin; k < end; k++) {
      for (size_t j = 0; j < y.size(); j++) {
        for (size_t i = 0; i < x.size(); i++) points[i + row * j + layer * k] = {x[i], y[j], z[k]};
      }
    }
  });

  std::uint32_t cornerOffset[8];
  for (size_t b = 0; b < 8; b++)
    cornerOffset[b] = static_cast<std::uint32_t>((b & 1) + row * (b >> 1 & 1) + layer * (b >> 2 & 1));
  TetMesh mesh;
  mesh.cells.resize(6 * nx * ny * nz);
  parallelFor(nz, 1, [&](size_t begin, size_t end, unsigned) {
    for (size_t k = begin; k < end; k++) {
      CellVertices* cell = &mesh.cells[6 * nx * ny * k];
      for (size_t j = 0; j < ny; j++) {
        for (size_t i = 0; i < nx; i++) {
          const std::uint32_t corner = static_cast<std::uint32_t>(i + row * j + layer * k);
          for (const auto& path : kBoxCells) {
            for (size_t v = 0; v < 4; v++) (*cell)[v] = corner + cornerOffset[path[v]];
            cell++;
          }
        }
      }
    }
  });
  mesh.points = std::move(points);
  return mesh;
}

Axis evenAxis(std::uint32_t n, double low, double high) {
  CHECK_LE(1u, n);
  CHECK_LT(low, high);
  Axis axis(size_t{n} + 1);
  for (size_t i = 0; i < n; i++) axis[i] = low + (high - low) * (static_cast<double>(i) / n);
  axis[n] = high;  // exactly, also where low + (high - low) is not
  return axis;
}

// 0 to 1 in n steps, each `growth` times the one before: (growth^i - 1) / (growth^n - 1).
Axis geometricAxis(std::uint32_t n, double growth) {
  if (growth == 1.0) return evenAxis(n, 0.0, 1.0);  // the limit, where the quotient is 0/0
  Axis axis(size_t{n} + 1);
  const double logGrowth = std::log(growth);
  for (size_t i = 0; i <= n; i++) axis[i] = std::expm1(static_cast<double>(i) * logGrowth) / std::expm1(n * logGrowth);
  return axis;
}

}  // namespace

TetMesh kuhnGrid(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz, const glm::dvec3& low, const glm::dvec3& high,
                 const FieldFunction& field, const std::string& fieldName) {
  TetMesh mesh = gridOnAxes(evenAxis(nx, low.x, high.x), evenAxis(ny, low.y, high.y), evenAxis(nz, low.z, high.z));
  addPreferredField(mesh, fieldName, field);
  return mesh;
}

// Why 1/6: in units of the box's edges the three edges along a cell's path are the unit vectors, each plus the
// difference of two moves, at most 2 jitter in each component. For jitter < 1/6 the matrix of the edges is strictly
// diagonally dominant (1 - 2 jitter > 4 jitter), hence never singular, and its determinant keeps the sign that it has
// at jitter 0.
TetMesh jitteredGrid(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz, const glm::dvec3& low,
                     const glm::dvec3& high, double jitter, std::uint32_t seed, const FieldFunction& field,
                     const std::string& fieldName) {
  CHECK_LE(0.0, jitter);
  TetMesh mesh = gridOnAxes(evenAxis(nx, low.x, high.x), evenAxis(ny, low.y, high.y), evenAxis(nz, low.z, high.z));
  std::vector<glm::dvec3>& points = std::get<std::vector<glm::dvec3>>(mesh.points);
  const glm::dvec3 edge = (high - low) / glm::dvec3(nx, ny, nz);
  const size_t row = size_t{nx} + 1;
  const size_t layer = row * (size_t{ny} + 1);
  parallelFor(nz - 1, 1, [&](size_t begin, size_t end, unsigned) {
    for (size_t k = begin + 1; k <= end; k++) {
      for (size_t j = 1; j < ny; j++) {
        for (size_t i = 1; i < nx; i++) {
          const size_t p = i + row * j + layer * k;
          const glm::dvec3 random(randomUnit(seed, 3 * p), randomUnit(seed, 3 * p + 1), randomUnit(seed, 3 * p + 2));
          points[p] += jitter * edge * (2.0 * random - 1.0);
        }
      }
    }
  });
  addPreferredField(mesh, fieldName, field);
  return mesh;
}

TetMesh gradedBox(std::uint32_t n, double ratio, const FieldFunction& field, const std::string& fieldName) {
  CHECK_LE(2u, n);
  CHECK_LE(1.0, ratio);
  const Axis axis = geometricAxis(n, std::pow(ratio, 1.0 / (n - 1)));
  TetMesh mesh = gridOnAxes(axis, axis, axis);
  addPreferredField(mesh, fieldName, field);
  return mesh;
}

}  // namespace tetralux
