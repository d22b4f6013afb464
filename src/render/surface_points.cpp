#include "render/surface_points.h"

#include <glm/common.hpp>

#include "base/check.h"

namespace tetralux::render {

SurfacePoints insertIsovalues(const std::vector<glm::vec4>& points, const std::vector<glm::vec2>& scalars,
                              const std::vector<float>& isovalues) {
  CHECK_EQ(points.size(), scalars.size() + 1);
  SurfacePoints result;
  constexpr float kNone = -1.0f;
  float last = 0.0f;
  float lastSurface = kNone;
  const auto add = [&](float scalar, const glm::vec4& optics, float surface) {
    if (!result.points.empty()) result.scalars.emplace_back(last, scalar, lastSurface, surface);
    result.points.push_back(optics);
    last = scalar;
    lastSurface = surface;
  };
  std::uint32_t next = 0;  // isosurface
  for (size_t i = 0; i < points.size(); i++) {
    const float scalar = i < scalars.size() ? scalars[i].x : scalars.back().y;
    // Isosurfaces below this point, and on it: behind its step's lower point, so that points stay in order.
    for (; next < isovalues.size() && isovalues[next] < scalar; next++) {
      const float low = scalars[i - 1].x;
      const float share = (isovalues[next] - low) / (scalar - low);
      add(isovalues[next], glm::mix(points[i - 1], points[i], share), static_cast<float>(next));
    }
    bool isTaken = false;
    for (; next < isovalues.size() && isovalues[next] == scalar; next++) {
      add(scalar, points[i], static_cast<float>(next));
      isTaken = true;
    }
    if (!isTaken) add(scalar, points[i], kNone);
  }
  return result;
}

}  // namespace tetralux::render
