#include "render/appearance_texels.h"

#include <algorithm>

#include "base/check.h"
#include "shared/appearance.h"

namespace tetralux::render {
namespace {

NumberRange rangeOf(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {0.5 * *low + 0.5 * *high, *high > *low ? *high - *low : 1.0};
}

void addCurve(const FactorCurve& curve, const NumberRange& range, std::vector<glm::vec4>& texels) {
  for (const FactorPoint& point : curve.points()) {
    texels.emplace_back(range.normalized(point.value), 0.0f, 0.0f, 0.0f);
    texels.emplace_back(glm::vec3(point.rgb), static_cast<float>(point.factor));
  }
}

void addTransfer(const TransferFunction2d& transfer, const NumberRange& gradients, const MeshSpace& space,
                 Emission emission, std::vector<glm::vec4>& texels) {
  for (const double s : transfer.scalars()) texels.emplace_back(space.scalar(s), 0.0f, 0.0f, 0.0f);
  for (const double g : transfer.gradients()) texels.emplace_back(gradients.normalized(g), 0.0f, 0.0f, 0.0f);
  const double perLength = emission == Emission::PerLength ? space.scale : 1.0;
  for (const OpticalSample& sample : transfer.samples())
    texels.emplace_back(glm::vec3(sample.luminance * perLength), static_cast<float>(sample.extinction * space.scale));
}

}  // namespace

bool AppearanceNumbers::any() const {
  return std::any_of(values.begin(), values.end(), [](const std::vector<double>* v) { return v != nullptr; });
}

AppearanceNumbers listNumbers(const Appearance& appearance, const AppearanceData& data) {
  AppearanceNumbers numbers;
  const auto use = [&](ModulatedBy by, const std::vector<double>& values) {
    numbers.values[static_cast<size_t>(by)] = &values;
    numbers.ranges[static_cast<size_t>(by)] = rangeOf(values);
  };
  CHECK_EQ(appearance.modulations.size(), data.modulators.size());
  for (size_t i = 0; i < appearance.modulations.size(); i++) {
    const Modulation& modulation = appearance.modulations[i];
    numbers.curves[static_cast<size_t>(modulation.by)] = &modulation.curve;
    if (modulation.by != ModulatedBy::ViewCosine) use(modulation.by, data.modulators[i]);
  }
  if (appearance.transfer2d) use(ModulatedBy::GradientMagnitude, data.gradientMagnitudes);
  return numbers;
}

std::vector<glm::vec4> listAppearanceTexels(const Appearance& appearance, const AppearanceNumbers& numbers,
                                            const MeshSpace& space, Emission emission) {
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
                emission, texels);
  return texels;
}

}  // namespace tetralux::render
