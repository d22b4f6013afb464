// The camera: where rays start and where they go.
//
// Spaces. World: the mesh file's coordinates. View: origin at the eye, x right, y up, z forward (depth, positive in
// front of the eye). Clip and ndc: x right, y up, both -1..1 over the image, w = depth under perspective and 1
// otherwise. Pixel (i, j) is column i, row j from the top; its centre has ndc x = 2 (i + 0.5)/w - 1 and
// y = 1 - 2 (j + 0.5)/h. Pixels are square.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

namespace tetralux {

enum class Projection { Perspective, Orthographic };

struct ImageSize {
  std::uint32_t width = 0;   // pixels, >= 1
  std::uint32_t height = 0;  // pixels, >= 1

  bool operator==(const ImageSize&) const = default;
};

// A ray through a pixel's centre: origin + depth * direction for depth >= 0.
struct Ray {
  glm::dvec3 origin{0.0};       // world; the eye, or a point of the eye's plane (orthographic)
  glm::dvec3 direction{0.0};    // world; its component along the view direction is 1, so `depth` is view-space z
  double lengthPerDepth = 1.0;  // |direction|: world length of a step of 1 in depth
};

struct Camera {
  Projection projection = Projection::Perspective;
  glm::dvec3 eye{0.0, -1.0, 0.0};  // world
  glm::dvec3 center{0.0};          // world; the view direction is center - eye
  glm::dvec3 up{0.0, 0.0, 1.0};    // any length, not along the view direction
  double fovyDegrees = 30.0;       // perspective: full vertical field of view, in (0, 180)
  double heightWorld = 1.0;        // orthographic: world height of the view, > 0

  bool operator==(const Camera&) const = default;

  // Rows: right, up, forward (unit vectors in the world). viewPosition = viewRotation * (world - eye).
  glm::dmat3 viewRotation() const;
  glm::dmat4 viewFromWorld() const;

  // Depth is not mapped to a range: clip z is the view depth.
  glm::dmat4 clipFromWorld(ImageSize size) const;

  // Pixels per unit of x/depth (perspective) or per world unit (orthographic); the same along x and y.
  double pixelsPerUnit(ImageSize size) const;

  Ray pixelRay(ImageSize size, double column, double row) const;

  // The camera turned about `center`, round the `up` axis, counter-clockwise seen from above.
  Camera turned(double degrees) const;
};

// Throws Error(Input) beginning with `place` when the camera cannot make a picture: eye = center, up along the view
// direction, an angle or height out of range, a number that is not finite.
void validate(const Camera& camera, std::string_view place);

// A perspective camera (30 degrees) that shows all points in an image of this shape, with a small margin, from in
// front, a little from the right and above, z up. Points without extent are shown as if they had the size 1.
//   points   world; at least one
Camera framingCamera(std::span<const glm::dvec3> points, ImageSize size);

}  // namespace tetralux
