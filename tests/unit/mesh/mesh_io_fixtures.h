// Meshes that the tests of readers and writers share, and how results are compared.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>

#include "base/error.h"
#include "mesh/tet_mesh.h"

namespace tetralux::test {

// Two cells, five points with whole coordinates (every number type holds them), a scalar and a vector at points and a
// scalar in cells; "a" is active.
inline TetMesh tinyMesh() {
  TetMesh mesh;
  mesh.points = std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {4, 5, 6}};
  mesh.cells = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  mesh.pointArrays.push_back({"a", 1, std::vector<float>{0.5f, 1.25f, -2, 3, 1e-20f}});
  mesh.pointArrays.push_back({"v", 3, std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 0.1}});
  mesh.cellArrays.push_back({"c", 1, std::vector<std::int32_t>{-7, 70000}});
  mesh.preferredField = "a";
  return mesh;
}

// The same points in another precision.
inline TetMesh withDoublePoints(TetMesh mesh) {
  const auto& points = std::get<std::vector<glm::vec3>>(mesh.points);
  mesh.points = std::vector<glm::dvec3>(points.begin(), points.end());
  return mesh;
}

inline void expectEqualArrays(const std::vector<DataArray>& actual, const std::vector<DataArray>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (size_t i = 0; i < actual.size(); i++) {
    EXPECT_EQ(actual[i].name, expected[i].name);
    EXPECT_EQ(actual[i].components, expected[i].components) << actual[i].name;
    EXPECT_TRUE(actual[i].values == expected[i].values)
        << actual[i].name << " " << actual[i].typeName() << " against " << expected[i].typeName();
  }
}

// Types included.
inline void expectEqual(const TetMesh& actual, const TetMesh& expected) {
  EXPECT_TRUE(actual.points == expected.points)
      << actual.pointCount() << (actual.hasDoublePoints() ? " double" : " float") << " points against "
      << expected.pointCount() << (expected.hasDoublePoints() ? " double" : " float");
  EXPECT_EQ(actual.cells, expected.cells);
  expectEqualArrays(actual.pointArrays, expected.pointArrays);
  expectEqualArrays(actual.cellArrays, expected.cellArrays);
  EXPECT_EQ(actual.preferredField, expected.preferredField);
}

// The message of the Error(code) that the action throws.
inline std::string errorOf(const std::function<void()>& action, ErrorCode code = ErrorCode::Input) {
  try {
    action();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), code) << e.what();
    return e.what();
  }
  return "no error";
}

// `text` with the first `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  if (at == std::string::npos)
    ADD_FAILURE() << "nothing to replace: " << from;
  else
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace tetralux::test
