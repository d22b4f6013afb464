#include <gtest/gtest.h>

#include <random>

#include "base/files.h"
#include "mesh/mesh_io.h"
#include "support/temp_dir.h"
#include "unit/mesh/mesh_io_fixtures.h"

namespace tetralux {
namespace {

using namespace test;

// Random cells and arrays of every type; numbers are bit patterns, NaNs left out for comparison.
TetMesh randomMesh(size_t points, size_t cells, bool doublePoints) {
  std::mt19937 random(7);
  TetMesh mesh;
  std::vector<glm::vec3> positions(points);
  for (auto& p : positions) p = glm::vec3(random(), random(), random()) * 1e-6f;
  mesh.points = positions;
  if (doublePoints) mesh = withDoublePoints(mesh);
  for (size_t i = 0; i < cells; i++) {
    CellVertices cell;
    for (auto& vertex : cell) vertex = static_cast<std::uint32_t>(random() % points);
    mesh.cells.push_back(cell);
  }
  const auto add = [&]<typename T>(const char* name, std::uint32_t components, T) {
    std::vector<T> values(points * components);
    for (T& value : values) value = static_cast<T>(random());
    mesh.pointArrays.push_back({name, components, values});
  };
  add("i8", 1, std::int8_t{});
  add("u8", 4, std::uint8_t{});
  add("i16", 1, std::int16_t{});
  add("u16", 1, std::uint16_t{});
  add("i32", 2, std::int32_t{});
  add("u32", 1, std::uint32_t{});
  add("i64", 1, std::int64_t{});
  add("u64", 1, std::uint64_t{});
  add("f32", 3, float{});
  add("f64", 1, double{});
  mesh.cellArrays.push_back({"cell", 1, std::vector<float>(cells, 0.25f)});
  mesh.preferredField = "u16";
  return mesh;
}

TEST(WriteVtu, AMeshComesBackEqual) {
  const TempDir dir;
  for (const bool compress : {false, true}) {
    for (const bool doublePoints : {false, true}) {
      // 2731 points of 12 bytes: one byte block more than 32 KiB; 8192 cells: whole blocks
      for (const auto& [points, cells] : {std::pair{5, 2}, {2731, 8192}, {2730, 8191}}) {
        const TetMesh mesh = randomMesh(static_cast<size_t>(points), static_cast<size_t>(cells), doublePoints);
        writeVtu(mesh, dir / "m.vtu", {compress});
        expectEqual(readVtu(dir / "m.vtu"), mesh);
      }
    }
  }
  EXPECT_EQ(dir.entries(), 1u);
}

TEST(WriteVtu, MoreBlocksThanAreCompressedAtOnceComeBackEqual) {
  const TempDir dir;
  const TetMesh mesh = randomMesh(1000, 600'000, false);
  for (const bool compress : {false, true}) {
    writeVtu(mesh, dir / "m.vtu", {compress});
    expectEqual(readVtu(dir / "m.vtu"), mesh);
  }
}

TEST(WriteVtu, NamesOfAnyKindComeBackEqual) {
  const TempDir dir;
  TetMesh mesh = tinyMesh();
  mesh.pointArrays[0].name = mesh.preferredField = "p < \"q\" & r > 's'";
  mesh.pointArrays[1].name = "tab\tline\nreturn\r \xc3\xa4 ";
  mesh.cellArrays[0].name = "";
  writeVtu(mesh, dir / "m.vtu");
  expectEqual(readVtu(dir / "m.vtu"), mesh);
}

TEST(WriteVtu, AnActiveCellArrayStaysActive) {
  const TempDir dir;
  TetMesh mesh = tinyMesh();
  mesh.preferredField = "c";
  writeVtu(mesh, dir / "m.vtu");
  expectEqual(readVtu(dir / "m.vtu"), mesh);
}

TEST(WriteVtu, IndicesTake32BitsWhereTheyFit) {
  const TempDir dir;
  writeVtu(tinyMesh(), dir / "m.vtu", {false});
  const std::string text = readTextFile(dir / "m.vtu");
  EXPECT_NE(text.find("type=\"Int32\" Name=\"connectivity\""), std::string::npos);
  EXPECT_NE(text.find("type=\"Int32\" Name=\"offsets\""), std::string::npos);
}

TEST(WriteVtu, CompressionMakesTheFileSmaller) {
  const TempDir dir;
  TetMesh mesh = randomMesh(100, 1, false);
  mesh.cells.assign(50'000, {0, 1, 2, 3});
  mesh.cellArrays.clear();
  writeVtu(mesh, dir / "plain.vtu", {false});
  writeVtu(mesh, dir / "small.vtu", {true});
  EXPECT_LT(std::filesystem::file_size(dir / "small.vtu") * 10, std::filesystem::file_size(dir / "plain.vtu"));
}

TEST(WriteVtu, APlaceThatCannotBeWrittenToIsNamedAndNothingIsLeft) {
  const TempDir dir;
  const std::string missing = (dir / "no" / "m.vtu").string();
  EXPECT_EQ(errorOf([&] { writeVtu(tinyMesh(), missing); }, ErrorCode::Output).substr(0, missing.size() + 1),
            missing + ":");
  std::filesystem::create_directory(dir / "m.vtu");
  EXPECT_EQ(errorOf([&] { writeVtu(tinyMesh(), dir / "m.vtu"); }, ErrorCode::Output),
            (dir / "m.vtu").string() + ": is a directory, expected a file name");
  EXPECT_EQ(dir.entries(), 1u);
}

}  // namespace
}  // namespace tetralux
