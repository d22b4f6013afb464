// A box with an appearance, for tests of what rays see of it.
#pragma once

#include <numeric>

#include "mesh/generate.h"
#include "reference/ray_painter.h"

namespace tetralux::reference {

struct PaintedBox {
  TetMesh mesh;  // of the box [0, 1]^3
  ScalarField field;
  TransferFunction transfer{{{0.0, {0, 0, 0}, 0.0}}, "nothing"};
  Camera camera;
  Appearance appearance;
  AppearanceData data;

  explicit PaintedBox(TetMesh box) : mesh(std::move(box)), field(scalarField(mesh, "", "test")) {}

  ReferenceScene scene(ImageSize size = {1, 1}) const {
    return {mesh, field, transfer, camera, size, &appearance, &data};
  }

  // One ray, tried on all cells.
  ReferencePixel paint(const Ray& ray) const {
    const ReferenceScene s = scene();
    std::vector<std::uint32_t> cells(mesh.cellCount());
    std::iota(cells.begin(), cells.end(), 0u);
    return RayPainter(s).paint(ray, cells);
  }

  std::vector<ReferencePixel> render(ImageSize size) const { return renderPixels(scene(size)); }
};

inline Ray rayFrom(const glm::dvec3& origin, const glm::dvec3& direction) {
  return {origin, direction, glm::length(direction)};
}

// The part of a ray in the box [0, 1]^3 in front of its origin, depths; none where front >= back. A ray in the border
// has none.
struct BoxChord {
  double front = 0.0;
  double back = 1e300;

  explicit BoxChord(const Ray& ray) {
    for (int axis = 0; axis < 3; axis++) {
      if (ray.direction[axis] == 0.0) {
        if (!(ray.origin[axis] > 0.0 && ray.origin[axis] < 1.0)) back = -1.0;
        continue;
      }
      const double a = (0.0 - ray.origin[axis]) / ray.direction[axis];
      const double b = (1.0 - ray.origin[axis]) / ray.direction[axis];
      front = std::max(front, std::min(a, b));
      back = std::min(back, std::max(a, b));
    }
  }
};

}  // namespace tetralux::reference
