#include "mesh_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace tetralux::test {
namespace {

IntPoint minus(const IntPoint& a, const IntPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

IntPoint cross(const IntPoint& a, const IntPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Int128 dot(const IntPoint& a, const IntPoint& b) {
  return static_cast<Int128>(a[0]) * b[0] + static_cast<Int128>(a[1]) * b[1] + static_cast<Int128>(a[2]) * b[2];
}

// The faces of a positive cell, anticlockwise seen from outside.
constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

// The same cycle for all three ways to write an oriented face.
std::array<std::uint32_t, 3> smallestFirst(std::array<std::uint32_t, 3> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

}  // namespace

Int128 volume6(const IntPoint& a, const IntPoint& b, const IntPoint& c, const IntPoint& d) {
  return dot(cross(minus(b, a), minus(c, a)), minus(d, a));
}

// The circumcentre m (relative to corner 0) solves 2 e_k . m = |e_k|^2 for the three edges e_k, so m = n / (2 V) with
// V = e1 x e2 . e3 > 0 and n = |e1|^2 e2 x e3 + |e2|^2 e3 x e1 + |e3|^2 e1 x e2. Inside: |q|^2 < 2 m . q.
Int128 insideSphere(const std::array<IntPoint, 4>& cell, const IntPoint& p) {
  const IntPoint q = minus(p, cell[0]);
  const IntPoint e1 = minus(cell[1], cell[0]);
  const IntPoint e2 = minus(cell[2], cell[0]);
  const IntPoint e3 = minus(cell[3], cell[0]);
  const Int128 volume = dot(cross(e1, e2), e3);
  return dot(e1, e1) * dot(cross(e2, e3), q) + dot(e2, e2) * dot(cross(e3, e1), q) +
         dot(e3, e3) * dot(cross(e1, e2), q) - volume * dot(q, q);
}

std::array<IntPoint, 4> IntMesh::corners(size_t cell) const {
  const auto& [a, b, c, d] = cells[cell];
  return {points[a], points[b], points[c], points[d]};
}

IntMesh inSteps(const TetMesh& mesh, double step) {
  IntMesh result;
  result.cells = mesh.cells;
  for (size_t i = 0; i < mesh.pointCount(); i++) {
    const glm::dvec3 p = mesh.point(i) / step;
    IntPoint whole;
    for (int axis = 0; axis < 3; axis++) {
      whole[static_cast<size_t>(axis)] = std::llround(p[axis]);
      if (std::round(p[axis]) != p[axis]) throw std::runtime_error("a coordinate is between two steps");
    }
    result.points.push_back(whole);
  }
  return result;
}

Topology topologyOf(const IntMesh& mesh) {
  Topology result;
  std::set<std::array<std::uint32_t, 3>> sides;  // oriented faces
  std::set<std::array<std::uint32_t, 2>> edges;
  std::set<std::uint32_t> used;
  for (size_t i = 0; i < mesh.cells.size(); i++) {
    const CellVertices& v = mesh.cells[i];
    const std::array<IntPoint, 4> corner = mesh.corners(i);
    const Int128 volume = volume6(corner[0], corner[1], corner[2], corner[3]);
    result.flatOrInverted += volume <= 0;
    result.volume6 += volume;
    for (const auto& [a, b, c] : kFaces) {
      const auto at = [&](int slot) { return v[static_cast<size_t>(slot)]; };
      if (!sides.insert(smallestFirst({at(a), at(b), at(c)})).second) result.mismatched++;
    }
    for (size_t a = 0; a < 4; a++) {
      used.insert(v[a]);
      for (size_t b = a + 1; b < 4; b++) edges.insert({std::min(v[a], v[b]), std::max(v[a], v[b])});
    }
  }
  for (const auto& side : sides) {
    if (!sides.count(smallestFirst({side[0], side[2], side[1]}))) result.border.push_back(side);
  }
  const size_t faces = (sides.size() + result.border.size()) / 2;
  result.usedPoints = used.size();
  result.eulerNumber =
      static_cast<std::int64_t>(used.size() + faces) - static_cast<std::int64_t>(edges.size() + mesh.cells.size());
  return result;
}

bool bordersConvexHull(const IntMesh& mesh, const Topology& topology) {
  return std::all_of(topology.border.begin(), topology.border.end(), [&](const auto& face) {
    return std::all_of(mesh.points.begin(), mesh.points.end(), [&](const IntPoint& p) {
      return volume6(mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]], p) <= 0;
    });
  });
}

bool isDelaunay(const IntMesh& mesh) {
  for (size_t i = 0; i < mesh.cells.size(); i++) {
    const std::array<IntPoint, 4> cell = mesh.corners(i);
    for (const IntPoint& p : mesh.points) {
      if (insideSphere(cell, p) > 0) return false;
    }
  }
  return true;
}

// Two convex polyhedra with disjoint interiors are separated by a plane parallel to a face of one or to an edge of
// each (the separating axis theorem).
bool interiorsDisjoint(const std::array<IntPoint, 4>& a, const std::array<IntPoint, 4>& b) {
  const auto edgesOf = [](const std::array<IntPoint, 4>& cell) {
    std::vector<IntPoint> edges;
    for (size_t i = 0; i < 4; i++) {
      for (size_t j = i + 1; j < 4; j++) edges.push_back(minus(cell[j], cell[i]));
    }
    return edges;
  };
  const std::vector<IntPoint> edgesA = edgesOf(a);
  const std::vector<IntPoint> edgesB = edgesOf(b);
  std::vector<IntPoint> normals;
  for (const IntPoint& e : edgesA) {
    for (const IntPoint& f : edgesA) normals.push_back(cross(e, f));
    for (const IntPoint& f : edgesB) normals.push_back(cross(e, f));
  }
  for (const IntPoint& e : edgesB) {
    for (const IntPoint& f : edgesB) normals.push_back(cross(e, f));
  }
  return std::any_of(normals.begin(), normals.end(), [&](const IntPoint& n) {
    if (n == IntPoint{0, 0, 0}) return false;
    const auto range = [&](const std::array<IntPoint, 4>& cell) {
      std::array<Int128, 4> heights;
      std::transform(cell.begin(), cell.end(), heights.begin(), [&](const IntPoint& p) { return dot(n, p); });
      return std::pair(*std::min_element(heights.begin(), heights.end()),
                       *std::max_element(heights.begin(), heights.end()));
    };
    const auto [lowA, highA] = range(a);
    const auto [lowB, highB] = range(b);
    return highA <= lowB || highB <= lowA;
  });
}

}  // namespace tetralux::test
