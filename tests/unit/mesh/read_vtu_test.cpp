#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh/mesh_io.h"
#include "support/temp_dir.h"
#include "unit/mesh/mesh_io_fixtures.h"
#include "unit/mesh/vtu_builder.h"

namespace tetralux {
namespace {

using namespace test;

TetMesh readText(const std::string& text) {
  const TempDir dir;
  return readVtu(dir.write("m.vtu", text));
}

TEST(ReadVtu, EveryEncodingGivesTheSameMesh) {
  const TempDir dir;
  size_t files = 0;
  for (const Placement placement :
       {Placement::Ascii, Placement::Inline, Placement::AppendedRaw, Placement::AppendedBase64}) {
    for (const Compression compression : {Compression::None, Compression::ZLib, Compression::Lz4, Compression::Lzma}) {
      for (const bool bigEndian : {false, true}) {
        for (const bool header64 : {false, true}) {
          VtuFormat format;
          format.placement = placement;
          format.compression = compression;
          format.bigEndian = bigEndian;
          format.header64 = header64;
          SCOPED_TRACE(fmt::format("placement {} compression {} big {} header64 {}", static_cast<int>(placement),
                                   static_cast<int>(compression), bigEndian, header64));
          expectEqual(readVtu(dir.write("m.vtu", buildVtu(tinyMesh(), format))), tinyMesh());
          files++;
        }
      }
    }
  }
  EXPECT_EQ(files, 64u);
}

TEST(ReadVtu, BlocksMayBeFullOrPartialOrLargerThanTheArray) {
  VtuFormat format;
  format.placement = Placement::AppendedRaw;
  format.compression = Compression::ZLib;
  for (const size_t blockSize : {8u, 20u, 40u, 1u << 15}) {  // "a" is 20 bytes
    SCOPED_TRACE(blockSize);
    format.blockSize = blockSize;
    expectEqual(readText(buildVtu(tinyMesh(), format)), tinyMesh());
  }
}

TEST(ReadVtu, EveryTypeOfIndexAndOfCoordinate) {
  const ArrayValues types[] = {std::vector<std::int8_t>(),   std::vector<std::uint8_t>(), std::vector<std::int16_t>(),
                               std::vector<std::uint16_t>(), std::vector<std::int32_t>(), std::vector<std::uint32_t>(),
                               std::vector<std::int64_t>(),  std::vector<std::uint64_t>()};
  for (const Placement placement : {Placement::Ascii, Placement::AppendedRaw}) {
    for (const ArrayValues& type : types) {
      const DataArray named{"", 1, type};
      SCOPED_TRACE(named.typeName());
      VtuFormat format;
      format.placement = placement;
      format.indexType = type;
      expectEqual(readText(buildVtu(tinyMesh(), format)), tinyMesh());
      format.coordinateType = type;
      expectEqual(readText(buildVtu(tinyMesh(), format)), withDoublePoints(tinyMesh()));
    }
    VtuFormat format;
    format.coordinateType = std::vector<double>();
    expectEqual(readText(buildVtu(tinyMesh(), format)), withDoublePoints(tinyMesh()));
  }
}

template <typename T>
DataArray extremes(const char* name) {
  using Limits = std::numeric_limits<T>;
  return {name, 1, std::vector<T>{Limits::lowest(), T(0), T(1), T(100), Limits::max()}};
}

TEST(ReadVtu, ArraysOfEveryTypeKeepTypeAndNumbers) {
  TetMesh mesh = tinyMesh();
  mesh.pointArrays = {extremes<std::int8_t>("i8"),    extremes<std::uint8_t>("u8"),   extremes<std::int16_t>("i16"),
                      extremes<std::uint16_t>("u16"), extremes<std::int32_t>("i32"),  extremes<std::uint32_t>("u32"),
                      extremes<std::int64_t>("i64"),  extremes<std::uint64_t>("u64"), extremes<float>("f32"),
                      extremes<double>("f64")};
  mesh.preferredField = "u16";
  for (const Placement placement : {Placement::Ascii, Placement::Inline, Placement::AppendedRaw}) {
    for (const bool bigEndian : {false, true}) {
      VtuFormat format;
      format.placement = placement;
      format.bigEndian = bigEndian;
      expectEqual(readText(buildVtu(mesh, format)), mesh);
    }
  }
}

TEST(ReadVtu, NonFiniteNumbersAreReadFromText) {
  TetMesh mesh = tinyMesh();
  std::get<std::vector<float>>(mesh.pointArrays[0].values) = {NAN, INFINITY, -INFINITY, 0, 1};
  const TetMesh read = readText(buildVtu(mesh, {}));
  const auto& values = std::get<std::vector<float>>(read.pointArrays[0].values);
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_EQ(values[1], INFINITY);
  EXPECT_EQ(values[2], -INFINITY);
}

TEST(ReadVtu, PiecesAreJoinedAndEmptyOnesPassedOver) {
  TetMesh second = tinyMesh();
  std::swap(second.pointArrays[0], second.pointArrays[1]);
  TetMesh joined = tinyMesh();
  std::get<std::vector<glm::vec3>>(joined.points).resize(10);
  for (size_t i = 0; i < 5; i++) {
    std::get<std::vector<glm::vec3>>(joined.points)[5 + i] = std::get<std::vector<glm::vec3>>(second.points)[i];
  }
  joined.cells = {{0, 1, 2, 3}, {1, 2, 3, 4}, {5, 6, 7, 8}, {6, 7, 8, 9}};
  for (auto* arrays : {&joined.pointArrays, &joined.cellArrays}) {
    for (DataArray& array : *arrays) {
      std::visit(
          [](auto& v) {
            auto twice = v;
            twice.insert(twice.end(), v.begin(), v.end());
            v = twice;
          },
          array.values);
    }
  }
  for (const Placement placement : {Placement::Ascii, Placement::AppendedRaw}) {
    VtuFormat format;
    format.placement = placement;
    expectEqual(readText(buildVtu({TetMesh(), tinyMesh(), TetMesh(), second}, format)), joined);
  }
}

TEST(ReadVtu, PiecesOfDifferentPrecisionGiveDoublePoints) {
  const std::string floats = buildVtu(std::vector{tinyMesh(), tinyMesh()}, {});
  const size_t second = floats.rfind("<DataArray type=\"Float32\" Name=\"Points\"");
  std::string mixed = floats;
  mixed.replace(second, 25, "<DataArray type=\"Float64\" ");
  const TetMesh mesh = readText(mixed);
  ASSERT_TRUE(mesh.hasDoublePoints());
  ASSERT_EQ(mesh.pointCount(), 10u);
  EXPECT_EQ(mesh.point(4), glm::dvec3(4, 5, 6));
  EXPECT_EQ(mesh.point(9), glm::dvec3(4, 5, 6));
}

TEST(ReadVtu, ActiveScalarsAreThoseOfPointsThenOfCells) {
  const std::string text = buildVtu(tinyMesh(), {});
  EXPECT_EQ(readText(replaced(text, " Scalars=\"a\"", "")).preferredField, "");
  EXPECT_EQ(readText(replaced(text, " Scalars=\"a\"", " Scalars=\"missing\"")).preferredField, "");
  EXPECT_EQ(readText(replaced(text, "<CellData>", "<CellData Scalars=\"c\">")).preferredField, "a");
  EXPECT_EQ(
      readText(replaced(replaced(text, " Scalars=\"a\"", ""), "<CellData>", "<CellData Scalars=\"c\">")).preferredField,
      "c");
}

TEST(ReadVtu, WhatOtherWritersLeaveInOrOutMakesNoDifference) {
  const std::string text = buildVtu(tinyMesh(), {});
  const std::pair<const char*, const char*> edits[] = {
      {"<VTKFile ", "<?xml version=\"1.0\"?>\n<VTKFile "},
      {"<VTKFile ", "\xef\xbb\xbf<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!-- note -->\n<VTKFile "},
      {" header_type=\"UInt32\"", ""},
      {" byte_order=\"LittleEndian\"", ""},
      {"<UnstructuredGrid>",
       "<UnstructuredGrid><FieldData><DataArray type=\"Float64\" Name=\"TIME\" "
       "NumberOfTuples=\"1\" format=\"ascii\">1.5</DataArray></FieldData>"},
      {"Name=\"a\" format=\"ascii\">",
       "Name=\"a\" format=\"ascii\" RangeMin=\"0\" RangeMax=\"\"><InformationKey name=\"L2_NORM_RANGE\" "
       "location=\"vtkDataArray\" length=\"2\"><Value index=\"0\">0</Value></InformationKey>"},
      {"Name=\"a\" format=\"ascii\">", "Name=\"a\">"},
      {"Name=\"Points\" NumberOfComponents=\"3\"", "Name=\"Points\""},
      {"Name=\"Points\"", "Name=\"anything\""},
      {"type=\"Int64\" Name=\"connectivity\"", "type=\"vtkIdType\" Name=\"connectivity\""},
      {"</Cells>", "<DataArray type=\"Int64\" Name=\"faces\" format=\"ascii\"></DataArray></Cells>"},
      {"NumberOfPoints=\"5\"", "NumberOfPoints=\"5     \""},
      {"<PointData Scalars=\"a\">",
       "<PointData Scalars=\"a\"><DataArray type=\"String\" Name=\"s\" format=\"ascii\">65 0"
       "</DataArray><Array type=\"String\" Name=\"t\" format=\"ascii\">65 0</Array>"
       "<DataArray type=\"Bit\" Name=\"b\" format=\"binary\">AAAA</DataArray>"},
      {"<CellData>", "<CellData><!-- none -->"},
  };
  for (const auto& [from, to] : edits) {
    SCOPED_TRACE(to);
    expectEqual(readText(replaced(text, from, to)), tinyMesh());
  }
}

TEST(ReadVtu, ASecondArrayOfANameIsLeftOut) {
  TetMesh mesh = tinyMesh();
  mesh.pointArrays.push_back(mesh.pointArrays[1]);
  mesh.pointArrays.back().name = "a";
  expectEqual(readText(buildVtu(mesh, {})), tinyMesh());
}

TEST(ReadVtu, AnArrayWithoutNameIsGivenOne) {
  const TetMesh mesh = readText(replaced(buildVtu(tinyMesh(), {}), "Name=\"v\" ", ""));
  EXPECT_EQ(mesh.pointArrays[1].name, "Array 1");
}

TEST(ReadVtu, Base64TextMayBeBrokenIntoLines) {
  VtuFormat format;
  format.placement = Placement::Inline;
  format.lineBreaks = true;
  expectEqual(readText(buildVtu(tinyMesh(), format)), tinyMesh());
  format.compression = Compression::Lz4;
  expectEqual(readText(buildVtu(tinyMesh(), format)), tinyMesh());
}

TEST(ReadVtu, AppendedDataWithoutAnEncodingIsBase64) {
  VtuFormat format;
  format.placement = Placement::AppendedBase64;
  expectEqual(readText(replaced(buildVtu(tinyMesh(), format), " encoding=\"base64\"", "")), tinyMesh());
}

TEST(ReadVtu, RawDataMayLookLikeTheEndOfItsElement) {
  TetMesh mesh = tinyMesh();
  std::vector<std::uint8_t> values;
  for (const char c : std::string("</AppendedData></VTKFile>_")) values.push_back(static_cast<std::uint8_t>(c));
  values.resize(50);
  mesh.pointArrays.push_back({"tag", 10, values});
  VtuFormat format;
  format.placement = Placement::AppendedRaw;
  expectEqual(readText(buildVtu(mesh, format)), mesh);
}

TEST(ReadVtu, ALargeCompressedMeshIsTheSameOnAllThreads) {
  TetMesh mesh;
  std::vector<glm::vec3> points;
  for (int i = 0; i < 20000; i++) points.push_back({i, i % 17, i % 5});
  mesh.points = points;
  for (std::uint32_t i = 0; i + 3 < points.size(); i++) mesh.cells.push_back({i, i + 1, i + 2, i + 3});
  VtuFormat format;
  format.placement = Placement::AppendedRaw;
  format.compression = Compression::ZLib;
  format.blockSize = 1000;  // not a multiple of any number's size
  expectEqual(readText(buildVtu(mesh, format)), mesh);
}

}  // namespace
}  // namespace tetralux
