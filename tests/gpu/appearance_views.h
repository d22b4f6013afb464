// Pictures of more than a volume, by rays that walk and by the reference.
#pragma once

#include "fields/appearance_data.h"
#include "image/metrics.h"
#include "projection_views.h"
#include "render/renderer.h"

namespace tetralux::test {

inline constexpr ImageSize kAppearanceSize{96, 72};

struct AppearancePair {
  Image drawn;
  Image exact;
  std::vector<std::uint32_t> crossings;  // of isosurfaces per pixel, as the reference counts them

  ImageDifference difference() const { return compareImages(exact, drawn); }
};

// One picture each.
//   field      name, or empty for the mesh's own
AppearancePair drawAppearance(const gpu::Context& context, const TetMesh& mesh, const TransferFunction& transfer,
                              const Appearance& appearance, const Camera& camera, ImageSize size = kAppearanceSize,
                              const render::RendererOptions& options = withProjection(render::CellProjection::March));

// The same of a field, with data that was made elsewhere.
AppearancePair drawPair(const gpu::Context& context, const TetMesh& mesh, const ScalarField& field,
                        const TransferFunction& transfer, const Appearance& appearance, const AppearanceData& data,
                        const Camera& camera, ImageSize size = kAppearanceSize,
                        const render::RendererOptions& options = withProjection(render::CellProjection::March));

// Errors of a picture, largest channel per pixel. Rays that graze a surface may meet it or not: rounding decides. So
// pixels with a neighbour whose ray crosses another number of isosurfaces in the exact picture, silhouettes, are
// counted apart.
struct SurfaceErrors {
  double largest = 0.0;  // of pixels that are no silhouettes
  double rmse = 0.0;     // likewise
  size_t silhouettes = 0;
  size_t over = 0;  // pixels of either kind that are off by more than 1/255
};
SurfaceErrors surfaceErrors(const AppearancePair& pair);

// A surface with light from the head and from the side.
Isosurface surfaceAt(double value, double opacity, Shading shading = Shading::Phong);
Lighting sideLight();

}  // namespace tetralux::test
