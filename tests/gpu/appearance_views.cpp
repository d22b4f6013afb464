#include "appearance_views.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "projection_views.h"
#include "reference/ray_caster.h"

namespace tetralux::test {

AppearancePair drawAppearance(const gpu::Context& context, const TetMesh& mesh, const TransferFunction& transfer,
                              const Appearance& appearance, const Camera& camera, ImageSize size,
                              const render::RendererOptions& options) {
  const ScalarField field = scalarField(mesh, "", "test");
  const AppearanceData data = makeAppearanceData(appearance, mesh, field, "test");
  return drawPair(context, mesh, field, transfer, appearance, data, camera, size, options);
}

AppearancePair drawPair(const gpu::Context& context, const TetMesh& mesh, const ScalarField& field,
                        const TransferFunction& transfer, const Appearance& appearance, const AppearanceData& data,
                        const Camera& camera, ImageSize size, const render::RendererOptions& options) {
  render::Renderer renderer(context, mesh, field, options);
  renderer.setTransferFunction(transfer);
  renderer.setAppearance(appearance, data);
  renderer.draw(camera, size);
  AppearancePair pair;
  pair.drawn = renderer.readImage();
  const auto pixels = reference::renderPixels({mesh, field, transfer, camera, size, &appearance, &data});
  pair.exact = reference::toImage(pixels, size);
  for (const reference::ReferencePixel& pixel : pixels) pair.crossings.push_back(pixel.crossings);
  return pair;
}

SurfaceErrors surfaceErrors(const AppearancePair& pair) {
  SurfaceErrors errors;
  const auto width = static_cast<std::int64_t>(pair.exact.width);
  const auto height = static_cast<std::int64_t>(pair.exact.height);
  const auto crossingsAt = [&](std::int64_t x, std::int64_t y) {
    return pair.crossings[static_cast<size_t>(std::clamp<std::int64_t>(y, 0, height - 1) * width +
                                              std::clamp<std::int64_t>(x, 0, width - 1))];
  };
  double sum = 0.0;
  size_t count = 0;
  for (std::int64_t y = 0; y < height; y++) {
    for (std::int64_t x = 0; x < width; x++) {
      bool isSilhouette = false;
      for (std::int64_t dy = -1; dy <= 1; dy++) {
        for (std::int64_t dx = -1; dx <= 1; dx++)
          isSilhouette = isSilhouette || crossingsAt(x + dx, y + dy) != crossingsAt(x, y);
      }
      const size_t i = static_cast<size_t>(y * width + x);
      const glm::vec4 d = glm::abs(pair.exact.pixels[i] - pair.drawn.pixels[i]);
      const auto error = static_cast<double>(std::max({d.x, d.y, d.z, d.w}));
      errors.over += error > 1.0 / 255.0 ? 1 : 0;
      errors.silhouettes += isSilhouette ? 1 : 0;
      if (isSilhouette) continue;
      errors.largest = std::max(errors.largest, error);
      sum += error * error;
      count++;
    }
  }
  errors.rmse = std::sqrt(sum / static_cast<double>(std::max<size_t>(count, 1)));
  return errors;
}

Isosurface surfaceAt(double value, double opacity, Shading shading) {
  Isosurface surface;
  surface.value = value;
  surface.rgb = {0.9, 0.5, 0.1};
  surface.backRgb = {0.1, 0.4, 0.8};
  surface.opacity = opacity;
  surface.shading = shading;
  return surface;
}

Lighting sideLight() {
  Lighting lighting;
  lighting.lights.push_back({glm::normalize(glm::dvec3(1.0, 2.0, 0.5)), {0.6, 0.8, 1.0}});
  return lighting;
}

}  // namespace tetralux::test
