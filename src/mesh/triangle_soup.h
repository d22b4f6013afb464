// Triangles as files have them, and the readers that give them.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace tetralux {

// Points may coincide, be unused or hold no finite number; indices are below points.size().
struct TriangleSoup {
  std::vector<glm::dvec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// One format each, whatever the file's name. All throw Error(Input).
TriangleSoup readStl(const std::filesystem::path& path);
TriangleSoup readPly(const std::filesystem::path& path);
TriangleSoup readObj(const std::filesystem::path& path);
TriangleSoup readVtp(const std::filesystem::path& path);

// Appends a polygon as a fan from its first vertex. Throws Error(Input) beginning with `place` where it has fewer than
// three vertices, or an index that is not below `pointCount`.
//   firstPoint   added to every index: points before this part of the file
void appendPolygon(TriangleSoup& soup, std::span<const std::int64_t> polygon, size_t firstPoint, size_t pointCount,
                   std::string_view place);

// Makes one point of those at the same place, and leaves out what then is no triangle, and unused points.
TriangleMesh welded(const TriangleSoup& soup);

}  // namespace tetralux
