#include "reference/cell_ray.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace tetralux::reference {
namespace {

// A ray that lies in the face of two cells belongs to one of them, as if it were moved aside by a distance that tends
// to zero, along x and by ever smaller ones along y and z (Edelsbrunner and Muecke 1990, "Simulation of simplicity").
//   normal   of the face, into the cell
bool isTowardsOneSide(const glm::dvec3& normal) {
  for (int axis = 0; axis < 3; axis++) {
    if (normal[axis] != 0.0) return normal[axis] > 0.0;
  }
  return false;
}

}  // namespace

CellGeometry::CellGeometry(const std::array<glm::dvec3, 4>& vertices, const std::array<double, 4>& scalars)
    : vertices_(vertices), scalars_(scalars) {
  // Barycentric coordinate i of p is normals_[i] . (p - any vertex of face i) / volume6_.
  const auto faceNormal = [&](int a, int b, int c) {
    const auto at = [&](int i) { return vertices_[static_cast<size_t>(i)]; };
    return glm::cross(at(b) - at(a), at(c) - at(a));
  };
  normals_ = {-faceNormal(1, 2, 3), faceNormal(0, 2, 3), -faceNormal(0, 1, 3), faceNormal(0, 1, 2)};
  volume6_ = glm::dot(vertices_[3] - vertices_[0], normals_[3]);
}

bool CellGeometry::intersect(const Ray& ray, CellSegment& segment) const {
  // Depths are counted from the point of the ray next to a vertex: coordinates are then as small as the cell, and
  // rounding as well.
  const double base = glm::dot(vertices_[0] - ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
  const glm::dvec3 origin = ray.origin + base * ray.direction;

  std::array<double, 4> offset;  // barycentric coordinate i at depth base + t is (offset + slope t) / volume6
  std::array<double, 4> slope;
  double front = -std::numeric_limits<double>::infinity();
  double back = std::numeric_limits<double>::infinity();
  const double sign = volume6_ > 0.0 ? 1.0 : -1.0;
  for (size_t i = 0; i < 4; i++) {
    offset[i] = sign * glm::dot(normals_[i], origin - vertices_[(i + 1) % 4]);
    slope[i] = sign * glm::dot(normals_[i], ray.direction);
    if (slope[i] > 0.0)
      front = std::max(front, -offset[i] / slope[i]);
    else if (slope[i] < 0.0)
      back = std::min(back, -offset[i] / slope[i]);
    else if (!(offset[i] > 0.0) && !(offset[i] == 0.0 && isTowardsOneSide(sign * normals_[i])))
      return false;
  }
  front = std::max(front, -base);  // nothing behind the ray's origin counts
  if (!(front < back)) return false;

  const auto [low, high] = std::minmax_element(scalars_.begin(), scalars_.end());
  const auto scalarAt = [&](double t) {
    double sum = 0.0;
    double weights = 0.0;
    for (size_t i = 0; i < 4; i++) {
      const double weight = std::max(0.0, offset[i] + slope[i] * t);
      sum += weight * scalars_[i];
      weights += weight;
    }
    return weights > 0.0 ? std::clamp(sum / weights, *low, *high) : *low;
  };
  segment = {base + front, base + back, scalarAt(front), scalarAt(back)};
  // The difference of the two depths is taken before `base` is added, where it is exact to the cell's size.
  segment.back = segment.front + (back - front);
  return true;
}

}  // namespace tetralux::reference
