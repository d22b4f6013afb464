#include "mesh/triangle_soup.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"

namespace tetralux {
namespace {

bool before(const glm::dvec3& a, const glm::dvec3& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

// For every point the first one at its place.
std::vector<std::uint32_t> firstAtSamePlace(const std::vector<glm::dvec3>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return before(points[a], points[b]); });
  std::vector<std::uint32_t> first(points.size());
  for (size_t i = 0; i < order.size(); i++) {
    const bool isSame = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = isSame ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace

void appendPolygon(TriangleSoup& soup, std::span<const std::int64_t> polygon, size_t firstPoint, size_t pointCount,
                   std::string_view place) {
  if (polygon.size() < 3) fail(ErrorCode::Input, "{}: {} vertices, expected at least 3", place, polygon.size());
  for (const std::int64_t index : polygon) {
    if (index < 0 || static_cast<std::uint64_t>(index) >= pointCount)
      fail(ErrorCode::Input, "{}: vertex index {}, expected below the number of points, {}", place, index, pointCount);
  }
  const auto vertex = [&](size_t k) {
    return static_cast<std::uint32_t>(firstPoint + static_cast<size_t>(polygon[k]));
  };
  for (size_t k = 1; k + 1 < polygon.size(); k++) soup.triangles.push_back({vertex(0), vertex(k), vertex(k + 1)});
}

TriangleMesh welded(const TriangleSoup& soup) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  const std::vector<std::uint32_t> first = firstAtSamePlace(soup.points);
  std::vector<std::uint32_t> numbers(soup.points.size(), kNone);
  TriangleMesh mesh;
  for (const auto& [a, b, c] : soup.triangles) {
    std::array<std::uint32_t, 3> triangle = {first[a], first[b], first[c]};
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    for (std::uint32_t& vertex : triangle) {
      std::uint32_t& number = numbers[vertex];
      if (number == kNone) {
        number = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.push_back(soup.points[vertex]);
      }
      vertex = number;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

}  // namespace tetralux
