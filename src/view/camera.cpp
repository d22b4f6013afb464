#include "view/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "base/error.h"

namespace tetralux {
namespace {

double tanHalfFovy(const Camera& camera) { return std::tan(glm::radians(camera.fovyDegrees) * 0.5); }

}  // namespace

glm::dmat3 Camera::viewRotation() const {
  const glm::dvec3 forward = glm::normalize(center - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::normalize(up)));
  const glm::dvec3 upward = glm::cross(right, forward);
  return glm::transpose(glm::dmat3(right, upward, forward));
}

glm::dmat4 Camera::viewFromWorld() const {
  const glm::dmat3 rotation = viewRotation();
  glm::dmat4 matrix(rotation);
  matrix[3] = glm::dvec4(rotation * -eye, 1.0);
  return matrix;
}

glm::dmat4 Camera::clipFromWorld(ImageSize size) const {
  const double scale = pixelsPerUnit(size);
  glm::dmat4 clipFromView(0.0);
  clipFromView[0][0] = 2.0 * scale / size.width;
  clipFromView[1][1] = 2.0 * scale / size.height;
  clipFromView[2][2] = 1.0;
  if (projection == Projection::Perspective)
    clipFromView[2][3] = 1.0;
  else
    clipFromView[3][3] = 1.0;
  return clipFromView * viewFromWorld();
}

double Camera::pixelsPerUnit(ImageSize size) const {
  return projection == Projection::Perspective ? size.height / (2.0 * tanHalfFovy(*this)) : size.height / heightWorld;
}

Ray Camera::pixelRay(ImageSize size, double column, double row) const {
  const glm::dmat3 worldFromView = glm::transpose(viewRotation());
  const double scale = pixelsPerUnit(size);
  const double x = (column + 0.5 - 0.5 * size.width) / scale;
  const double y = (0.5 * size.height - row - 0.5) / scale;
  if (projection == Projection::Perspective)
    return {eye, worldFromView * glm::dvec3(x, y, 1.0), std::sqrt(x * x + y * y + 1.0)};
  return {eye + worldFromView * glm::dvec3(x, y, 0.0), worldFromView * glm::dvec3(0.0, 0.0, 1.0), 1.0};
}

Camera Camera::turned(double degrees) const {
  Camera result = *this;
  const glm::dmat4 rotation = glm::rotate(glm::dmat4(1.0), glm::radians(degrees), glm::normalize(up));
  result.eye = center + glm::dmat3(rotation) * (eye - center);
  return result;
}

void validate(const Camera& camera, std::string_view place) {
  const auto checkFinite = [&](const char* name, const glm::dvec3& v) {
    for (int i = 0; i < 3; i++) {
      if (!std::isfinite(v[i]))
        fail(ErrorCode::Input, "{}: {}[{}] is {}, expected a finite number", place, name, i, v[i]);
    }
  };
  checkFinite("eye", camera.eye);
  checkFinite("center", camera.center);
  checkFinite("up", camera.up);
  const glm::dvec3 view = camera.center - camera.eye;
  const double distance = glm::length(view);
  if (!(distance > 0.0) || !std::isfinite(distance))
    fail(ErrorCode::Input, "{}: eye and center are both ({}, {}, {}), expected two different points", place,
         camera.eye.x, camera.eye.y, camera.eye.z);
  const double upLength = glm::length(camera.up);
  // The sine of the angle between up and the view direction; below this the picture's roll is rounding error.
  constexpr double kSmallestSine = 1e-9;
  if (!(upLength > 0.0) || !(glm::length(glm::cross(view / distance, camera.up / upLength)) > kSmallestSine))
    fail(ErrorCode::Input, "{}: up is ({}, {}, {}), expected a direction that is not along the view", place,
         camera.up.x, camera.up.y, camera.up.z);
  if (camera.projection == Projection::Perspective) {
    if (!(camera.fovyDegrees > 0.0 && camera.fovyDegrees < 180.0))
      fail(ErrorCode::Input, "{}: fovy is {}, expected degrees between 0 and 180", place, camera.fovyDegrees);
  } else if (!(camera.heightWorld > 0.0) || !std::isfinite(camera.heightWorld)) {
    fail(ErrorCode::Input, "{}: height is {}, expected a positive number", place, camera.heightWorld);
  }
}

Camera framingCamera(std::span<const glm::dvec3> points, ImageSize size) {
  glm::dvec3 low = points.front();
  glm::dvec3 high = points.front();
  for (const glm::dvec3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  Camera camera;
  camera.center = 0.5 * low + 0.5 * high;
  const glm::dvec3 towardsEye = glm::normalize(glm::dvec3(0.45, -1.0, 0.5));
  camera.eye = camera.center + towardsEye;
  const glm::dmat3 rotation = camera.viewRotation();
  const double tanY = tanHalfFovy(camera);
  const double tanX = tanY * size.width / size.height;
  // The distance at which the last point comes into view: |x| <= (distance + z) tanX, and the same for y.
  double distance = 0.0;
  for (const glm::dvec3& point : points) {
    const glm::dvec3 p = rotation * (point - camera.center);
    distance = std::max({distance, std::abs(p.x) / tanX - p.z, std::abs(p.y) / tanY - p.z});
  }
  if (!(distance > 0.0)) distance = 1.0 / std::min(tanX, tanY);
  constexpr double kMargin = 1.04;
  camera.eye = camera.center + towardsEye * (distance * kMargin);
  return camera;
}

}  // namespace tetralux
