// Pictures of one mesh by one projection, compared with the exact ones.
#pragma once

#include <string>

#include "image/metrics.h"
#include "render/renderer.h"

namespace tetralux::test {

inline constexpr ImageSize kProjectionSize{96, 72};

render::RendererOptions withProjection(render::CellProjection projection, bool wideAddressing = false);

// A picture with orderTransfer().
//   field   name, or empty for the mesh's own
Image projectedImage(const gpu::Context& context, const TetMesh& mesh, const Camera& camera,
                     const render::RendererOptions& options, const std::string& field = "",
                     ImageSize size = kProjectionSize);

// Its difference from the double-precision reference.
ImageDifference projectionError(const gpu::Context& context, const TetMesh& mesh, const Camera& camera,
                                const render::RendererOptions& options, const std::string& field = "",
                                ImageSize size = kProjectionSize);

// Meshes that are hard for projections and walks, none with overlapping cells.
struct NamedMesh {
  std::string name;
  TetMesh mesh;
};
std::vector<NamedMesh> hardMeshes();

}  // namespace tetralux::test
