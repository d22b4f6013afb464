// The list of texels that says what is shown beside the volume (shared/appearance.h), and the numbers at vertices that
// it speaks of.
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <vector>

#include "render/mesh_space.h"
#include "volume/appearance.h"

namespace tetralux::render {

// Numbers at vertices become (a - center) / range.
struct NumberRange {
  double center = 0.0;
  double range = 1.0;

  float normalized(double a) const { return static_cast<float>((a - center) / range); }
};

// Of the numbers that modulations depend on, in the order of ModulatedBy; cosines stay as they are.
constexpr size_t kNumberKinds = 4;

struct AppearanceNumbers {
  std::array<NumberRange, kNumberKinds> ranges;
  std::array<const std::vector<double>*, kNumberKinds> values{};  // null where nothing uses them
  std::array<const FactorCurve*, kNumberKinds> curves{};          // null where there is none

  bool any() const;
};

// At most one modulation of each kind counts. Refers to both arguments.
AppearanceNumbers listNumbers(const Appearance& appearance, const AppearanceData& data);

// All texels; those of clip planes, which depend on the view, are zero.
std::vector<glm::vec4> listAppearanceTexels(const Appearance& appearance, const AppearanceNumbers& numbers,
                                            const MeshSpace& space);

}  // namespace tetralux::render
