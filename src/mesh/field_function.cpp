#include "mesh/field_function.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "base/parallel.h"

namespace tetralux {

void addPointField(TetMesh& mesh, const std::string& name, const FieldFunction& field) {
  constexpr size_t kGrain = 1 << 14;
  std::vector<double> values(mesh.pointCount());
  parallelFor(values.size(), kGrain, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) values[i] = field(mesh.point(i));
  });
  mesh.pointArrays.push_back({name, 1, std::move(values)});
}

void addPreferredField(TetMesh& mesh, const std::string& name, const FieldFunction& field) {
  addPointField(mesh, name, field);
  mesh.preferredField = name;
}

double waveField(const glm::dvec3& position) {
  // Frequencies without a common period, so that no symmetric mesh gets a symmetric field.
  return 0.5 + (std::sin(5.0 * position.x) + std::sin(6.0 * position.y) + std::sin(7.0 * position.z)) / 6.0;
}

FieldFunction distanceField(const glm::dvec3& center) {
  return [center](const glm::dvec3& position) { return glm::distance(position, center); };
}

}  // namespace tetralux
