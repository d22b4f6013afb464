// The independent answer: one ray per pixel in double precision.
//
// Every cell that a ray meets is found by itself, without adjacency; its segments are sorted by their middles and
// composited from the front with the exact integral of each. Nothing here is shared with the device's path, and
// nothing here is tuned to match it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"
#include "mesh/tet_mesh.h"
#include "view/camera.h"
#include "volume/appearance.h"
#include "volume/transfer_function.h"

namespace tetralux::reference {

struct ReferenceScene {
  const TetMesh& mesh;
  const ScalarField& field;
  const TransferFunction& transfer;
  const Camera& camera;
  ImageSize size;
  const Appearance* appearance = nullptr;  // null: the volume alone
  const AppearanceData* data = nullptr;    // of the appearance; not null when that is not
};

struct ReferencePixel {
  glm::dvec3 light{0.0};
  double alpha = 0.0;
  std::uint32_t layers = 0;     // cells met
  std::uint32_t pieces = 0;     // linear pieces of their segments, cut at control points (piece_count.h)
  std::uint32_t crossings = 0;  // of isosurfaces, composited
};

// One value per pixel, row by row from the top. All processors; a progress bar. Memory beside the result: 12 bytes
// per cell, 4 per cell and tile of 16 x 16 pixels that it covers, and the segments of one tile per thread.
std::vector<ReferencePixel> renderPixels(const ReferenceScene& scene);

struct PixelPosition {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
};

// Only the pixels asked for, in the order asked for. Positions must lie inside the image.
std::vector<ReferencePixel> renderPixels(const ReferenceScene& scene, std::span<const PixelPosition> positions);

// The pixels of a whole image, rounded to single precision.
Image toImage(const std::vector<ReferencePixel>& pixels, ImageSize size);

}  // namespace tetralux::reference
