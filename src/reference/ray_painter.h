// What a ray sees of a scene with an appearance (docs/appearance.md).
#pragma once

#include <cstdint>
#include <span>

#include "reference/ray_caster.h"
#include "reference/surface_tiles.h"

namespace tetralux::reference {

// One for all threads.
class RayPainter {
 public:
  // Refers to the scene, which must have an appearance and its data.
  explicit RayPainter(const ReferenceScene& scene);

  // What the ray sees of these cells, and of a surface behind them.
  //   cells   that it meets, in any order
  //   hit     where it meets an opaque surface
  ReferencePixel paint(const Ray& ray, std::span<const std::uint32_t> cells, const SurfaceHit& hit = {}) const;

 private:
  const ReferenceScene& scene_;
};

}  // namespace tetralux::reference
