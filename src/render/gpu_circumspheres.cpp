#include "render/gpu_circumspheres.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/packing.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "base/parallel.h"
#include "mesh/circumcenters.h"
#include "mesh/cospherical.h"

namespace tetralux::render {
namespace {

constexpr size_t kGrain = 1 << 14;

struct Spheres {
  std::vector<glm::vec4> leading;
  std::vector<glm::uvec2> rest;  // four times 16 bits (snorm): in units of 2^-24 of the leading number

  explicit Spheres(size_t count) : leading(count), rest(count) {}
};

// Centre, and power of the origin.
//   center   relative to the cell's first vertex, world
glm::dvec4 sphereOf(const TetMesh& mesh, const MeshSpace& space, size_t cell, const glm::dvec3& center) {
  const CellVertices& v = mesh.cells[cell];
  const glm::dvec3 first = space.position(mesh.point(*std::min_element(v.begin(), v.end())));
  glm::dvec3 relative = center / space.scale;
  // To 40 bits, a sphere of this radius is a plane; and powers stay far from the largest float.
  constexpr double kLargestRadius = 0x1p40;
  const double radius = glm::length(relative);
  if (radius > kLargestRadius) relative *= kLargestRadius / radius;
  return glm::dvec4(first + relative, glm::dot(first, first + 2.0 * relative));
}

void pack(const glm::dvec4& sphere, glm::vec4& leading, glm::uvec2& rest) {
  leading = glm::vec4(sphere);
  glm::vec4 share(0.0f);
  for (int i = 0; i < 4; i++) {
    const double unit = std::abs(static_cast<double>(leading[i])) * 0x1p-24;
    if (unit > 0.0) share[i] = static_cast<float>((sphere[i] - static_cast<double>(leading[i])) / unit);
  }
  rest = {glm::packSnorm2x16({share.x, share.y}), glm::packSnorm2x16({share.z, share.w})};
}

Spheres packSpheres(const TetMesh& mesh, const Adjacency& adjacency, const MeshSpace& space) {
  const std::vector<glm::dvec3> centers = circumcenters(mesh);
  const std::vector<std::uint32_t> sharedWith = cosphericalCells(mesh, adjacency, centers);
  Spheres spheres(mesh.cellCount());
  parallelFor(mesh.cellCount(), kGrain, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) {
      const std::uint32_t cell = sharedWith[i];
      pack(sphereOf(mesh, space, cell, centers[cell]), spheres.leading[i], spheres.rest[i]);
    }
  });
  return spheres;
}

}  // namespace

GpuCircumspheres::GpuCircumspheres(const gpu::Context& context, const TetMesh& mesh, const Adjacency& adjacency,
                                   const MeshSpace& space) {
  const Spheres spheres = packSpheres(mesh, adjacency, space);
  leading_ = gpu::makeBuffer(context, spheres.leading, "sphere leading parts");
  rest_ = gpu::makeBuffer(context, spheres.rest, "sphere rests");
  leadingView_ = gpu::TexelView(context, leading_, VK_FORMAT_R32G32B32A32_SFLOAT);
  restView_ = gpu::TexelView(context, rest_, VK_FORMAT_R32G32_UINT);
}

}  // namespace tetralux::render
