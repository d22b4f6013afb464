#include "mesh/vtk_assemble.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <limits>
#include <type_traits>

#include "base/error.h"
#include "mesh/vtk_text.h"
#include "mesh/vtk_types.h"

namespace tetralux {
namespace {

// Calls visitor(numbers) for values of an integer type. `what` names the array in the message otherwise.
template <typename Visitor>
void visitIntegers(const ArrayValues& values, const char* what, std::string_view place, const Visitor& visitor) {
  std::visit(
      [&](const auto& v) {
        using T = typename std::decay_t<decltype(v)>::value_type;
        if constexpr (std::is_integral_v<T>) {
          visitor(v);
        } else {
          fail(ErrorCode::Input, "{}: {} of type {}, expected an integer type", place, what,
               std::is_same_v<T, float> ? "Float32" : "Float64");
        }
      },
      values);
}

template <typename Point, typename T>
void appendAs(std::vector<Point>& points, const std::vector<T>& coordinates) {
  using Coordinate = typename Point::value_type;
  points.reserve(points.size() + coordinates.size() / 3);
  for (size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    points.push_back(Point(static_cast<Coordinate>(coordinates[i]), static_cast<Coordinate>(coordinates[i + 1]),
                           static_cast<Coordinate>(coordinates[i + 2])));
  }
}

}  // namespace

void appendPoints(TetMesh& mesh, const ArrayValues& coordinates) {
  const auto* floats = std::get_if<std::vector<float>>(&coordinates);
  if (mesh.pointCount() == 0) {
    if (floats)
      mesh.points = std::vector<glm::vec3>();
    else
      mesh.points = std::vector<glm::dvec3>();
  } else if (!floats && !mesh.hasDoublePoints()) {
    const auto& narrow = std::get<std::vector<glm::vec3>>(mesh.points);
    mesh.points = std::vector<glm::dvec3>(narrow.begin(), narrow.end());
  }
  std::visit([](auto& points, const auto& numbers) { appendAs(points, numbers); }, mesh.points, coordinates);
}

void checkCellTypes(const ArrayValues& types, std::string_view place) {
  visitIntegers(types, "cell types", place, [&](const auto& v) {
    for (size_t i = 0; i < v.size(); i++) {
      if (v[i] != kTetrahedronType)
        fail(ErrorCode::Input,
             "{}: cell {}: cell type {} ({}), expected {} (tetrahedron); other cells are not read yet", place, i, v[i],
             cellTypeName(static_cast<std::int64_t>(v[i])), kTetrahedronType);
    }
  });
}

void checkCellEnds(const ArrayValues& ends, std::string_view place) {
  visitIntegers(ends, "offsets", place, [&](const auto& v) {
    for (size_t i = 0; i < v.size(); i++) {
      if (static_cast<std::uint64_t>(v[i]) != 4 * (i + 1))
        fail(ErrorCode::Input, "{}: cell {}: ends after vertex {} of the connectivity, expected {}", place, i, v[i],
             4 * (i + 1));
    }
  });
}

void appendCells(TetMesh& mesh, const ArrayValues& vertices, size_t firstPoint, size_t pointCount,
                 std::string_view place) {
  visitIntegers(vertices, "connectivity", place, [&](const auto& v) {
    const size_t firstCell = mesh.cells.size();
    mesh.cells.resize(firstCell + v.size() / 4);
    for (size_t i = 0; i < v.size(); i++) {
      // A negative index becomes a huge one.
      const auto index = static_cast<std::uint64_t>(v[i]);
      if (index >= pointCount)
        fail(ErrorCode::Input, "{}: cell {}: vertex index {}, expected below the number of points, {}", place, i / 4,
             v[i], pointCount);
      mesh.cells[firstCell + i / 4][i % 4] = static_cast<std::uint32_t>(firstPoint + index);
    }
  });
}

void addArray(std::vector<DataArray>& arrays, DataArray&& array, std::string_view place) {
  if (std::any_of(arrays.begin(), arrays.end(), [&](const DataArray& a) { return a.name == array.name; })) {
    spdlog::warn("{}: a second array of the same name is left out", oneLine(place));
    return;
  }
  arrays.push_back(std::move(array));
}

void checkPointCount(std::uint64_t points, std::string_view place) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (points > kMost) fail(ErrorCode::Input, "{}: {} points, expected no more than {}", place, points, kMost);
}

}  // namespace tetralux
