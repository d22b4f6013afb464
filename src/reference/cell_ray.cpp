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

// Smaller shares of a weight are rounding: a sum of four terms is off by a few 1e-16, a thin cell's by more.
constexpr double kNoWeight = 1e-12;

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

bool CellGeometry::pass(const Ray& ray, Passage& passage) const {
  // Depths are counted from the point of the ray next to a vertex: coordinates are then as small as the cell, and
  // rounding as well.
  passage.base = glm::dot(vertices_[0] - ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
  const glm::dvec3 origin = ray.origin + passage.base * ray.direction;

  passage.front = -std::numeric_limits<double>::infinity();
  passage.back = std::numeric_limits<double>::infinity();
  const double sign = volume6_ > 0.0 ? 1.0 : -1.0;
  for (size_t i = 0; i < 4; i++) {
    const double offset = passage.offset[i] = sign * glm::dot(normals_[i], origin - vertices_[(i + 1) % 4]);
    const double slope = passage.slope[i] = sign * glm::dot(normals_[i], ray.direction);
    const double t = -offset / slope;
    if (slope > 0.0) {
      if (t > passage.front) passage.front = t, passage.faceFront = i;
    } else if (slope < 0.0) {
      if (t < passage.back) passage.back = t, passage.faceBack = i;
    } else if (!(offset > 0.0) && !(offset == 0.0 && isTowardsOneSide(sign * normals_[i]))) {
      return false;
    }
  }
  if (passage.front < -passage.base) {  // nothing behind the ray's origin counts
    passage.front = -passage.base;
    passage.faceFront = 4;
  }
  return passage.front < passage.back;
}

bool CellGeometry::intersect(const Ray& ray, CellSegment& segment) const {
  Passage p;
  if (!pass(ray, p)) return false;
  const auto [low, high] = std::minmax_element(scalars_.begin(), scalars_.end());
  const auto scalarAt = [&](double t) {
    double sum = 0.0;
    double weights = 0.0;
    for (size_t i = 0; i < 4; i++) {
      const double weight = std::max(0.0, p.offset[i] + p.slope[i] * t);
      sum += weight * scalars_[i];
      weights += weight;
    }
    return weights > 0.0 ? std::clamp(sum / weights, *low, *high) : *low;
  };
  segment = {p.base + p.front, p.base + p.back, scalarAt(p.front), scalarAt(p.back)};
  // The difference of the two depths is taken before `base` is added, where it is exact to the cell's size.
  segment.back = segment.front + (p.back - p.front);
  return true;
}

bool CellGeometry::intersect(const Ray& ray, CellChord& chord) const {
  Passage p;
  if (!pass(ray, p)) return false;
  const auto place = [&](double t, size_t face, std::array<double, 4>& weights, double& scalar) {
    double sum = 0.0;
    for (size_t i = 0; i < 4; i++) {
      weights[i] = i == face ? 0.0 : std::max(0.0, p.offset[i] + p.slope[i] * t);
      sum += weights[i];
    }
    if (!(sum > 0.0)) {  // a cell as small as rounding
      for (size_t i = 0; i < 4; i++) weights[i] = i == face ? 0.0 : 1.0;
      sum = face < 4 ? 3.0 : 4.0;
    }
    double snapped = 0.0;
    for (double& weight : weights) {
      if (weight < kNoWeight * sum) weight = 0.0;
      snapped += weight;
    }
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    scalar = 0.0;
    for (size_t i = 0; i < 4; i++) {
      weights[i] /= snapped;
      if (weights[i] == 0.0) continue;
      scalar += weights[i] * scalars_[i];
      low = std::min(low, scalars_[i]);
      high = std::max(high, scalars_[i]);
    }
    scalar = std::clamp(scalar, low, high);
  };
  CellSegment& segment = chord.segment;
  place(p.front, p.faceFront, chord.weightsFront, segment.sFront);
  place(p.back, p.faceBack, chord.weightsBack, segment.sBack);
  segment.front = p.base + p.front;
  segment.back = segment.front + (p.back - p.front);
  return true;
}

glm::dvec3 CellGeometry::gradient() const {
  glm::dvec3 sum(0.0);
  for (size_t i = 1; i < 4; i++) sum += (scalars_[i] - scalars_[0]) * normals_[i];
  return sum / volume6_;
}

}  // namespace tetralux::reference
