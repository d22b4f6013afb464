#include "render/appearance_texels.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "shared/appearance.h"

namespace tetralux::render {
namespace {

// Around the places where something depends on a number: there its digits matter, whatever values it has elsewhere.
NumberRange rangeOf(const std::vector<double>& places) {
  const auto [low, high] = std::minmax_element(places.begin(), places.end());
  return {0.5 * *low + 0.5 * *high, *high > *low ? *high - *low : std::max(std::abs(*high), 1e-300)};
}

void addCurve(const FactorCurve& curve, const NumberRange& range, std::vector<glm::vec4>& texels) {
  for (const FactorPoint& point : curve.points()) {
    texels.emplace_back(range.normalized(point.value), 0.0f, 0.0f, 0.0f);
    texels.emplace_back(glm::vec3(point.rgb), static_cast<float>(point.factor));
  }
}

void addTransfer(const TransferFunction2d& transfer, const NumberRange& gradients, const MeshSpace& space,
                 std::vector<glm::vec4>& texels) {
  for (const double s : transfer.scalars()) texels.emplace_back(space.scalar(s), 0.0f, 0.0f, 0.0f);
  for (const double g : transfer.gradients()) texels.emplace_back(gradients.normalized(g), 0.0f, 0.0f, 0.0f);
  for (const OpticalSample& sample : transfer.samples())
    texels.emplace_back(glm::vec3(sample.luminance), static_cast<float>(sample.extinction * space.scale));
}

}  // namespace

bool AppearanceNumbers::any() const {
  return std::any_of(values.begin(), values.end(), [](const std::vector<double>* v) { return v != nullptr; });
}

AppearanceNumbers listNumbers(const Appearance& appearance, const AppearanceData& data) {
  AppearanceNumbers numbers;
  std::array<std::vector<double>, kNumberKinds> places;
  CHECK_EQ(appearance.modulations.size(), data.modulators.size());
  for (size_t i = 0; i < appearance.modulations.size(); i++) {
    const Modulation& modulation = appearance.modulations[i];
    const auto kind = static_cast<size_t>(modulation.by);
    numbers.curves[kind] = &modulation.curve;
    if (modulation.by == ModulatedBy::ViewCosine) continue;
    numbers.values[kind] = &data.modulators[i];
    for (const FactorPoint& point : modulation.curve.points()) places[kind].push_back(point.value);
  }
  if (appearance.transfer2d) {
    const auto kind = static_cast<size_t>(ModulatedBy::GradientMagnitude);
    const std::vector<double>& axis = appearance.transfer2d->gradients();
    numbers.values[kind] = &data.gradientMagnitudes;
    places[kind].insert(places[kind].end(), axis.begin(), axis.end());
  }
  for (size_t kind = 0; kind < kNumberKinds; kind++) {
    if (!places[kind].empty()) numbers.ranges[kind] = rangeOf(places[kind]);
  }
  return numbers;
}

std::vector<glm::vec4> listAppearanceTexels(const Appearance& appearance, const AppearanceNumbers& numbers,
                                            const MeshSpace& space) {
  std::vector<glm::vec4> texels(appearance.clip.size() * shared::APPEARANCE_CLIP_TEXELS);
  const Lighting& lighting = appearance.lighting;
  texels.emplace_back(lighting.ambient, lighting.diffuse, lighting.specular, lighting.shininess);
  for (const DirectionalLight& light : lighting.lights) {
    texels.emplace_back(glm::vec3(light.direction), 0.0f);  // mesh space is not turned
    texels.emplace_back(glm::vec3(light.rgb), 0.0f);
  }
  for (const Isosurface& surface : appearance.isosurfaces) {
    texels.emplace_back(glm::vec3(surface.rgb), static_cast<float>(surface.opacity));
    texels.emplace_back(glm::vec3(surface.backRgb), static_cast<float>(surface.shading));
  }
  for (size_t kind = 0; kind < kNumberKinds; kind++) {
    if (numbers.curves[kind]) addCurve(*numbers.curves[kind], numbers.ranges[kind], texels);
  }
  if (appearance.transfer2d)
    addTransfer(*appearance.transfer2d, numbers.ranges[static_cast<size_t>(ModulatedBy::GradientMagnitude)], space,
                texels);
  return texels;
}

}  // namespace tetralux::render
