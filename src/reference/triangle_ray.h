// One ray and triangles that leave no cracks.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "view/camera.h"

namespace tetralux::reference {

struct TriangleHit {
  double depth = 0.0;               // along the ray (Ray::direction), > 0
  std::array<double, 3> weights{};  // barycentric, >= 0, together 1
};

// A ray prepared for triangles, after Woop, Benthin and Wald (2013, "Watertight Ray/Triangle Intersection"): corners
// are sheared along the ray into a plane, where a triangle is met when the ray's point is on the same side of all three
// edges. The side is exact for the sheared corners, and a point in an edge is taken to lie an infinitely small step
// aside, the same for all (Edelsbrunner and Muecke 1990): of triangles around an edge or a corner it is in as many as a
// point beside it. Corners are shared by having the same coordinates.
class TriangleRay {
 public:
  explicit TriangleRay(const Ray& ray);

  // Whether the ray passes through in front of its origin; then `hit` is set.
  //   corners   world
  bool meet(const std::array<glm::dvec3, 3>& corners, TriangleHit& hit) const;

 private:
  // A corner relative to the origin: in the plane, and along the ray's longest axis.
  struct Corner {
    glm::dvec2 place;
    double along;
  };

  Corner sheared(const glm::dvec3& corner) const;

  glm::dvec3 origin_;
  int axis_;  // the direction's longest component
  glm::dvec3 direction_;
};

}  // namespace tetralux::reference
