#include "render/mesh_space.h"

#include <algorithm>
#include <cmath>

#include "base/two_floats.h"

namespace tetralux::render {

glm::vec3 MeshSpace::roundedPosition(const glm::dvec3& world) const { return glm::vec3(position(world)); }

glm::vec3 MeshSpace::positionRest(const glm::dvec3& world) const {
  const glm::dvec3 exact = position(world);
  return {restOfFloat(exact.x), restOfFloat(exact.y), restOfFloat(exact.z)};
}

float MeshSpace::scalar(double s) const {
  // Control points of a transfer function may lie anywhere; the shaders expect finite numbers.
  constexpr double kLargest = 1e30;
  return static_cast<float>(std::clamp((s - scalarCenter) / scalarRange, -kLargest, kLargest));
}

MeshSpace makeMeshSpace(const TetMesh& mesh, const ScalarField& field) {
  MeshSpace space;
  const Bounds bounds = mesh.bounds();
  space.center = bounds.center();
  const glm::dvec3 half = 0.5 * bounds.high - 0.5 * bounds.low;
  const double largest = std::max({half.x, half.y, half.z});
  space.scale = largest > 0.0 ? std::exp2(std::ceil(std::log2(largest))) : 1.0;
  space.low = space.position(bounds.low);
  space.high = space.position(bounds.high);
  // Halves first: the sum or difference of two large values may be infinite.
  space.scalarCenter = 0.5 * field.low + 0.5 * field.high;
  const double halfRange = 0.5 * field.high - 0.5 * field.low;
  space.scalarRange = halfRange > 0.0 ? 2.0 * halfRange : 1.0;
  return space;
}

}  // namespace tetralux::render
