#include "volume/lighting.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tetralux {

Illumination illuminate(const Lighting& lighting, const glm::dvec3& normal, const glm::dvec3& toEye) {
  const double length = glm::length(normal);
  glm::dvec3 n = length > 0.0 ? normal / length : toEye;
  if (glm::dot(n, toEye) < 0.0) n = -n;
  Illumination result{glm::dvec3(lighting.ambient), glm::dvec3(0.0)};
  const auto add = [&](const glm::dvec3& towards, const glm::dvec3& rgb) {
    const double cosine = glm::dot(n, towards);
    if (!(cosine > 0.0)) return;
    result.factor += lighting.diffuse * cosine * rgb;
    const double mirrored = std::max(0.0, glm::dot(2.0 * cosine * n - towards, toEye));
    result.highlight += lighting.specular * std::pow(mirrored, lighting.shininess) * rgb;
  };
  if (lighting.headLight) add(toEye, glm::dvec3(1.0));
  for (const DirectionalLight& light : lighting.lights) add(light.direction, light.rgb);
  return result;
}

}  // namespace tetralux
