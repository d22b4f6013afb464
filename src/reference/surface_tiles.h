// Opaque surfaces, and which of their triangles rays see.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "reference/pixel_tiles.h"
#include "reference/triangle_ray.h"
#include "volume/appearance.h"

namespace tetralux::reference {

// The nearest triangle of a ray; infinitely far where there is none.
struct SurfaceHit {
  double depth = std::numeric_limits<double>::infinity();
  const OpaqueSurface* surface = nullptr;
  std::uint32_t triangle = 0;
  std::array<double, 3> weights{};  // of its corners
};

// World.
std::array<glm::dvec3, 3> triangleCorners(const OpaqueSurface& surface, size_t triangle);

// The colour that is seen there, lit as the surface is.
glm::dvec3 surfaceColour(const SurfaceHit& hit, const Ray& ray, const Lighting& lighting);

// All surfaces' triangles, sorted into tiles of the image. 12 bytes per triangle, 4 per triangle and tile that it
// reaches.
class SurfaceTiles {
 public:
  // Refers to the surfaces.
  SurfaceTiles(const std::vector<OpaqueSurface>& surfaces, const Camera& camera, ImageSize size);

  // Of two triangles at the same depth, the earlier one.
  //   ray    of the pixel
  //   x, y   inside the image
  SurfaceHit nearest(const Ray& ray, std::uint32_t x, std::uint32_t y) const;

 private:
  struct Item {
    std::uint32_t surface = 0;
    std::uint32_t triangle = 0;
  };

  const std::vector<OpaqueSurface>& surfaces_;
  std::vector<Item> items_;
  std::optional<PixelTiles> tiles_;
};

}  // namespace tetralux::reference
