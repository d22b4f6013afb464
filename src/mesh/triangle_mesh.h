// Surfaces of triangles, read from files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <vector>

namespace tetralux {

// Every index is below points.size(), and the three of a triangle differ; no two points are at the same place, and
// each belongs to a triangle.
struct TriangleMesh {
  std::vector<glm::dvec3> points;  // world units, finite
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Reads a surface; the format is chosen by the file's name:
//   .stl   text or binary
//   .ply   text or binary, both byte orders: elements "vertex" and "face"
//   .obj   lines "v" and "f"; no other file is opened
//   .vtp   VTK XML polygonal data in all encodings that readVtu() knows: polygons and strips
// The result has at least one triangle. Polygons are cut into fans from their first vertex. Vertices, lines and edges
// are left out with a warning; so are, without one, triangles with two corners at one place, and everything that is not
// geometry.
// Throws Error(Input): one line with the file, the place in it, the value found and the value expected. A damaged file
// takes no more memory than its bytes can stand for.
TriangleMesh readTriangleMesh(const std::filesystem::path& path);

}  // namespace tetralux
