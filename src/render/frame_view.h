// Camera and image as the shaders want them.
#pragma once

#include "render/mesh_space.h"
#include "shared/cell_push.h"
#include "shared/frame_view.h"
#include "view/camera.h"

namespace tetralux::render {

struct FrameSetup {
  shared::FrameView view;
  shared::ScreenScale screen;
  double smallestPixel = 0.0;  // side of a pixel where the mesh is nearest to the eye, mesh units
  bool perspective = true;
  // Cells may reach or come close to the eye's plane: the shaders' near-cell path is needed.
  bool nearCells = false;
};

// Everything is computed in double precision relative to the mesh and then rounded.
//   keyBits   bits of the sort key, 1 to 24
FrameSetup makeFrameSetup(const Camera& camera, ImageSize size, const MeshSpace& space, std::uint32_t cellCount,
                          std::uint32_t supportCount, std::uint32_t keyBits);

}  // namespace tetralux::render
