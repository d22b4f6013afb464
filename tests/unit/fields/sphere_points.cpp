#include "unit/fields/sphere_points.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <optional>

#include "mesh/random.h"

namespace tetralux::test {
namespace {

// Where the ray from `center` meets {s = radius} in a cell.
std::optional<SpherePoint> crossing(const TetMesh& mesh, const CellVertices& cell, std::span<const double> s,
                                    const glm::dvec3& center, const glm::dvec3& direction, double radius) {
  const glm::dvec3 corner = mesh.point(cell[0]);
  const glm::dmat3 edges(mesh.point(cell[1]) - corner, mesh.point(cell[2]) - corner, mesh.point(cell[3]) - corner);
  const glm::dmat3 barycentric = glm::inverse(edges);
  const glm::dvec3 rise(s[cell[1]] - s[cell[0]], s[cell[2]] - s[cell[0]], s[cell[3]] - s[cell[0]]);
  const glm::dvec3 start = barycentric * (center - corner);
  const glm::dvec3 step = barycentric * direction;
  const double t = (radius - s[cell[0]] - glm::dot(rise, start)) / glm::dot(rise, step);
  const glm::dvec3 b = start + t * step;
  const double first = 1.0 - b.x - b.y - b.z;
  if (!(t > 0.0 && first >= 0.0 && b.x >= 0.0 && b.y >= 0.0 && b.z >= 0.0)) return std::nullopt;
  return SpherePoint{cell, {first, b.x, b.y, b.z}, direction};
}

}  // namespace

std::vector<SpherePoint> spherePoints(const TetMesh& mesh, std::span<const double> distances, const glm::dvec3& center,
                                      double radius, size_t count) {
  std::vector<CellVertices> crossed;
  for (const CellVertices& cell : mesh.cells) {
    const auto inside = std::count_if(cell.begin(), cell.end(), [&](auto v) { return distances[v] < radius; });
    if (inside != 0 && inside != 4) crossed.push_back(cell);
  }
  std::vector<SpherePoint> points;
  for (size_t i = 0; i < count; i++) {
    const double z = 2.0 * randomUnit(1, 2 * i) - 1.0;
    const double angle = 2.0 * std::numbers::pi * randomUnit(1, 2 * i + 1);
    const double r = std::sqrt(1.0 - z * z);
    const glm::dvec3 direction(r * std::cos(angle), r * std::sin(angle), z);
    for (const CellVertices& cell : crossed) {
      if (const auto point = crossing(mesh, cell, distances, center, direction, radius)) {
        points.push_back(*point);
        break;
      }
    }
  }
  return points;
}

std::vector<double> anglesToNormals(const std::vector<SpherePoint>& points, std::span<const glm::dvec3> vectors) {
  std::vector<double> angles;
  for (const SpherePoint& point : points) {
    glm::dvec3 v(0.0);
    for (size_t k = 0; k < 4; k++) v += point.weights[k] * vectors[point.cell[k]];
    const double sine = glm::length(glm::cross(v, point.normal));
    angles.push_back(std::atan2(sine, glm::dot(v, point.normal)) * 180.0 / std::numbers::pi);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

}  // namespace tetralux::test
