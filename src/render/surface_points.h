// The control points that rays walk by, with every isovalue among them.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace tetralux::render {

// As TransferTables' points, and which of them are isosurfaces.
struct SurfacePoints {
  std::vector<glm::vec4> points;
  // Of each point and the next: their scalars; the indices of the isosurfaces at them, or -1.
  std::vector<glm::vec4> scalars;
};

// Inserts a point for every isovalue, whose optics are those of the transfer function there; on a step it is one of the
// step's points, so that the surface is met once in either direction.
//   points, scalars   of TransferTables
//   isovalues         normalised, ascending
SurfacePoints insertIsovalues(const std::vector<glm::vec4>& points, const std::vector<glm::vec2>& scalars,
                              const std::vector<float>& isovalues);

}  // namespace tetralux::render
