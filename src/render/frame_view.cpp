#include "render/frame_view.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "base/two_floats.h"
#include "shared/clipped_cells.h"

namespace tetralux::render {
namespace {

// Nearer than this to the eye, mesh units, cells are few and pixels may be as small as they like.
constexpr double kNearestLooked = 0.02;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

// Range of a function over the corners of the mesh's box.
template <typename Function>
Range overCorners(const MeshSpace& space, const Function& function) {
  Range range;
  for (int corner = 0; corner < 8; corner++) {
    const glm::dvec3 p((corner & 1) ? space.high.x : space.low.x, (corner & 2) ? space.high.y : space.low.y,
                       (corner & 4) ? space.high.z : space.low.z);
    const double value = function(p);
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range;
}

// Distances from the eye to the mesh's box, less |eye|.
Range distanceRange(const MeshSpace& space, const glm::dvec3& eye) {
  const double eyeLength = glm::length(eye);
  const auto relative = [&](const glm::dvec3& p) {
    // |p - eye| - |eye| without cancellation for an eye that is far away.
    return glm::dot(p, p - 2.0 * eye) / (glm::length(p - eye) + eyeLength);
  };
  Range range = overCorners(space, relative);
  range.low = relative(glm::clamp(eye, space.low, space.high));
  return range;
}

}  // namespace

FrameSetup makeFrameSetup(const Camera& camera, ImageSize size, const MeshSpace& space, std::uint32_t cellCount,
                          std::uint32_t supportCount, std::uint32_t keyBits) {
  FrameSetup setup;
  setup.perspective = camera.projection == Projection::Perspective;
  const glm::dmat3 rotation = camera.viewRotation();
  const glm::dvec3 eye = space.position(camera.eye);
  const glm::dvec3 translation = rotation * -eye;
  // x/z has no unit; an orthographic x is in mesh units here.
  const double pixelsPerUnit = camera.pixelsPerUnit(size) * (setup.perspective ? 1.0 : space.scale);

  shared::FrameView& view = setup.view;
  for (int row = 0; row < 3; row++) {
    const glm::dvec4 exact(rotation[0][row], rotation[1][row], rotation[2][row], translation[row]);
    view.viewFromMesh[row] = glm::vec4(exact);
    for (int column = 0; column < 4; column++) view.viewFromMeshRest[row][column] = restOfFloat(exact[column]);
  }
  view.eyeMesh = glm::vec4(eye, glm::length(eye));
  view.halfSize = 0.5f * glm::vec2(size.width, size.height);
  view.pixelsPerUnit = static_cast<float>(pixelsPerUnit);
  view.pixelsPerUnitRest = restOfFloat(pixelsPerUnit);
  view.keyBits = keyBits;
  view.cellCount = cellCount;
  view.supportCount = supportCount;

  const Range depth =
      overCorners(space, [&](const glm::dvec3& p) { return glm::dot(glm::transpose(rotation)[2], p) + translation.z; });
  const Range distance = setup.perspective ? distanceRange(space, eye) : depth;
  const double nearest = std::max(distance.low + glm::length(eye), kNearestLooked);
  setup.smallestPixel = (setup.perspective ? nearest : 1.0) / pixelsPerUnit;
  view.keyLow = static_cast<float>(distance.low);
  view.keyPerDistance = static_cast<float>(1.0 / std::max(distance.high - distance.low, 1e-30));
  // The shaders' criterion for cells, taken for the whole box and with a margin for rounding.
  constexpr double kRatio = 1.1 * static_cast<double>(shared::NEAR_DEPTH_RATIO);
  setup.nearCells = depth.low < depth.high * (setup.perspective ? kRatio : 1e-6);

  setup.screen.halfSize = view.halfSize;
  setup.screen.unitsPerPixel = static_cast<float>(1.0 / pixelsPerUnit);
  return setup;
}

}  // namespace tetralux::render
