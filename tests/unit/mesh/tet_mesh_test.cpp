#include "mesh/tet_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "base/error.h"

namespace tetralux {
namespace {

using ::testing::HasSubstr;

TetMesh oneCell() {
  TetMesh mesh;
  mesh.points = std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.cells = {{0, 1, 2, 3}};
  mesh.pointArrays.push_back({"a", 1, std::vector<float>{1, 2, 3, 4}});
  mesh.pointArrays.push_back({"v", 3, std::vector<double>{3, 4, 0, 0, 0, 0, 1, 0, 0, 2, 3, 6}});
  mesh.cellArrays.push_back({"c", 1, std::vector<std::uint8_t>{7}});
  return mesh;
}

std::string errorOf(const auto& action) {
  try {
    action();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::Input);
    return e.what();
  }
  return "no error";
}

TEST(TetMesh, BoundsHoldAllPoints) {
  const Bounds b = oneCell().bounds();
  EXPECT_EQ(b.low, glm::dvec3(0.0));
  EXPECT_EQ(b.high, glm::dvec3(1.0));
  EXPECT_DOUBLE_EQ(b.diagonal(), std::sqrt(3.0));
}

TEST(TetMesh, FieldIsFoundAtPointsThenInCells) {
  const TetMesh mesh = oneCell();
  const ScalarField a = scalarField(mesh, "a", "m");
  EXPECT_EQ(a.association, FieldAssociation::Point);
  EXPECT_EQ(a.low, 1.0);
  EXPECT_EQ(a.high, 4.0);
  const ScalarField c = scalarField(mesh, "c", "m");
  EXPECT_EQ(c.association, FieldAssociation::Cell);
  EXPECT_EQ(c.values, std::vector<double>{7.0});
}

TEST(TetMesh, VectorFieldIsItsLength) {
  EXPECT_EQ(scalarField(oneCell(), "v", "m").values, (std::vector<double>{5, 0, 1, 7}));
}

TEST(TetMesh, DefaultFieldIsThePreferredElseTheFirstScalar) {
  TetMesh mesh = oneCell();
  EXPECT_EQ(scalarField(mesh, "", "m").name, "a");
  mesh.preferredField = "v";
  EXPECT_EQ(scalarField(mesh, "", "m").name, "v");
}

TEST(TetMesh, MissingFieldListsTheOthers) {
  EXPECT_EQ(errorOf([] { scalarField(oneCell(), "b", "f.vtu"); }),
            "f.vtu: no array 'b', the mesh has 'a', 'v', 'c' (cells)");
}

TEST(TetMesh, NonFiniteValueOfTheFieldIsNamedAndUnusedArraysMayHoldIt) {
  TetMesh mesh = oneCell();
  std::get<std::vector<float>>(mesh.pointArrays[0].values)[2] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(errorOf([&] { scalarField(mesh, "a", "f.vtu"); }),
            "f.vtu: array 'a': point 2: value is nan, expected a finite number");
  EXPECT_NO_THROW(scalarField(mesh, "v", "f.vtu"));
}

TEST(TetMesh, ValidateNamesTheFirstDefect) {
  TetMesh mesh = oneCell();
  EXPECT_NO_THROW(validate(mesh, "f"));
  mesh.cells.push_back({0, 1, 2, 4});
  EXPECT_THAT(errorOf([&] { validate(mesh, "f"); }), HasSubstr("f: cell 1: vertex index 4, expected below"));
  mesh = oneCell();
  std::get<std::vector<glm::vec3>>(mesh.points)[3].y = std::numeric_limits<float>::infinity();
  EXPECT_EQ(errorOf([&] { validate(mesh, "f"); }), "f: point 3: coordinate y is inf, expected a finite number");
  mesh = oneCell();
  mesh.pointArrays[0].values = std::vector<float>{1};
  EXPECT_THAT(errorOf([&] { validate(mesh, "f"); }), HasSubstr("expected 4 tuples"));
}

}  // namespace
}  // namespace tetralux
