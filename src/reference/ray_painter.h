// What a ray sees of a scene with an appearance (docs/appearance.md).
#pragma once

#include <cstdint>
#include <span>

#include "reference/ray_caster.h"

namespace tetralux::reference {

// One for all threads.
class RayPainter {
 public:
  // Refers to the scene, which must have an appearance and its data.
  explicit RayPainter(const ReferenceScene& scene);

  // What the ray sees of these cells.
  //   cells   that it meets, in any order
  ReferencePixel paint(const Ray& ray, std::span<const std::uint32_t> cells) const;

 private:
  const ReferenceScene& scene_;
};

}  // namespace tetralux::reference
