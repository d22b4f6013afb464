#include "reference/surface_tiles.h"

#include <glm/geometric.hpp>

namespace tetralux::reference {

std::array<glm::dvec3, 3> triangleCorners(const OpaqueSurface& surface, size_t triangle) {
  const auto& corners = surface.triangles[triangle];
  return {surface.points[corners[0]], surface.points[corners[1]], surface.points[corners[2]]};
}

glm::dvec3 surfaceColour(const SurfaceHit& hit, const Ray& ray, const Lighting& lighting) {
  const OpaqueSurface& surface = *hit.surface;
  const auto corners = triangleCorners(surface, hit.triangle);
  glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const glm::dvec3& rgb = glm::dot(normal, ray.direction) < 0.0 ? surface.rgb : surface.backRgb;
  if (surface.shading == Shading::None) return rgb;
  if (surface.shading == Shading::Phong) {
    normal = glm::dvec3(0.0);
    for (size_t i = 0; i < 3; i++) normal += hit.weights[i] * surface.normals[surface.triangles[hit.triangle][i]];
  }
  return illuminate(lighting, normal, -ray.direction / ray.lengthPerDepth).lit(rgb);
}

SurfaceTiles::SurfaceTiles(const std::vector<OpaqueSurface>& surfaces, const Camera& camera, ImageSize size)
    : surfaces_(surfaces) {
  for (std::uint32_t s = 0; s < surfaces.size(); s++) {
    for (std::uint32_t t = 0; t < surfaces[s].triangles.size(); t++) items_.push_back({s, t});
  }
  const CellFootprint footprint(camera, size);
  tiles_.emplace(
      items_.size(),
      [&](size_t i) { return footprint(triangleCorners(surfaces[items_[i].surface], items_[i].triangle)); }, size);
}

SurfaceHit SurfaceTiles::nearest(const Ray& ray, std::uint32_t x, std::uint32_t y) const {
  constexpr auto kSide = static_cast<std::uint32_t>(PixelTiles::kSide);
  SurfaceHit nearest;
  const TriangleRay triangleRay(ray);
  for (const std::uint32_t i : tiles_->cells((y / kSide) * tiles_->columns() + x / kSide)) {
    const Item item = items_[i];
    TriangleHit hit;
    if (!triangleRay.meet(triangleCorners(surfaces_[item.surface], item.triangle), hit) || !(hit.depth < nearest.depth))
      continue;
    nearest = {hit.depth, &surfaces_[item.surface], item.triangle, hit.weights};
  }
  return nearest;
}

}  // namespace tetralux::reference
