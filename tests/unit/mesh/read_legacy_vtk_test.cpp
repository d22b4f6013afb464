#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesh/mesh_io.h"
#include "support/temp_dir.h"
#include "unit/mesh/legacy_builder.h"
#include "unit/mesh/mesh_io_fixtures.h"

namespace tetralux {
namespace {

using namespace test;

TetMesh readText(const std::string& text) {
  const TempDir dir;
  return readLegacyVtk(dir.write("m.vtk", text));
}

// The message, with "m.vtk" for the file's whole name.
std::string readError(const std::string& text) {
  const TempDir dir;
  const std::filesystem::path path = dir.write("m.vtk", text);
  return replaced(errorOf([&] { readLegacyVtk(path); }), path.string(), "m.vtk");
}

std::vector<LegacyFormat> allFormats() {
  std::vector<LegacyFormat> formats;
  for (const bool binary : {false, true}) {
    for (const bool version5 : {false, true}) {
      for (const bool metadata : {false, true}) formats.push_back({binary, version5, metadata});
    }
  }
  return formats;
}

TEST(ReadLegacyVtk, EveryVersionAndEncodingGivesTheSameMesh) {
  for (const LegacyFormat& format : allFormats()) {
    SCOPED_TRACE(fmt::format("binary {} version5 {} metadata {}", format.binary, format.version5, format.metadata));
    expectEqual(readText(buildLegacy(tinyMesh(), format)), tinyMesh());
    expectEqual(readText(buildLegacy(withDoublePoints(tinyMesh()), format)), withDoublePoints(tinyMesh()));
  }
}

TEST(ReadLegacyVtk, IndicesOfBothWidths) {
  for (const bool binary : {false, true}) {
    expectEqual(readText(buildLegacy(tinyMesh(), {binary, true, false, std::vector<std::int32_t>()})), tinyMesh());
  }
}

TEST(ReadLegacyVtk, ArraysOfEveryTypeKeepTypeAndNumbers) {
  TetMesh mesh = tinyMesh();
  mesh.pointArrays = {{"i8", 1, std::vector<std::int8_t>{-128, 127, 0, 1, 2}},
                      {"u8", 1, std::vector<std::uint8_t>{0, 255, 0, 1, 2}},
                      {"i16", 1, std::vector<std::int16_t>{-32768, 32767, 0, 1, 2}},
                      {"u16", 1, std::vector<std::uint16_t>{0, 65535, 0, 1, 2}},
                      {"i32", 1, std::vector<std::int32_t>{INT32_MIN, INT32_MAX, 0, 1, 2}},
                      {"u32", 1, std::vector<std::uint32_t>{0, UINT32_MAX, 0, 1, 2}},
                      {"i64", 1, std::vector<std::int64_t>{INT64_MIN, INT64_MAX, 0, 1, 2}},
                      {"u64", 1, std::vector<std::uint64_t>{0, UINT64_MAX, 0, 1, 2}},
                      {"f32", 1, std::vector<float>{-1.5f, 3e38f, 0, 1, 2}},
                      {"f64", 2, std::vector<double>{-1.5, 3e300, 0, 1, 2, 3, 4, 5, 6, 7}}};
  mesh.preferredField = "";
  for (const LegacyFormat& format : allFormats()) expectEqual(readText(buildLegacy(mesh, format)), mesh);
}

TEST(ReadLegacyVtk, OtherNamesOfTypes) {
  const std::string grid = legacyGrid(tinyMesh(), {});
  const auto typeOf = [&](const std::string& name) {
    const TetMesh mesh = readText(grid + "POINT_DATA 5\nSCALARS s " + name + "\nLOOKUP_TABLE default\n1 2 3 4 5\n");
    return std::string(mesh.pointArrays.at(0).typeName());
  };
  EXPECT_EQ(typeOf("long"), "Int64");
  EXPECT_EQ(typeOf("unsigned_long"), "UInt64");
  EXPECT_EQ(typeOf("signed_char"), "Int8");
  EXPECT_EQ(typeOf("FLOAT"), "Float32");
  EXPECT_EQ(typeOf("vtkIdType"), "Int32");
}

TEST(ReadLegacyVtk, EscapedNamesAreDecoded) {
  TetMesh mesh = tinyMesh();
  mesh.pointArrays[0].name = mesh.preferredField = "mass fraction %";
  mesh.pointArrays[1].name = "a\"b";
  for (const LegacyFormat& format : allFormats()) expectEqual(readText(buildLegacy(mesh, format)), mesh);
  const std::string grid = legacyGrid(tinyMesh(), {});
  EXPECT_EQ(readText(grid + "CELL_DATA 2\nSCALARS 5%x%2 int\nLOOKUP_TABLE default\n1 2\n").preferredField, "5%x%2");
}

TEST(ReadLegacyVtk, EveryKindOfAttribute) {
  const std::vector<float> numbers = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17};
  for (const bool binary : {false, true}) {
    const LegacyFormat format{binary, true, binary};
    const auto data = [&](size_t count) {
      return legacyNumbers(std::vector<float>(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count)),
                           format);
    };
    const TetMesh mesh = readText(
        legacyGrid(tinyMesh(), format) + "FIELD FieldData 2\nTIME 1 1 float\n" + data(1) + "NULL_ARRAY\nCELL_DATA 2\n" +
        "SCALARS s2 float 2\nLOOKUP_TABLE mine\n" + data(4) + "LOOKUP_TABLE mine 1\n" +
        (binary ? "\x01\x02\x03\x04\n" : "0 0.5 1 1\n") + "VECTORS vec float\n" + data(6) + "NORMALS nor float\n" +
        data(6) + "TENSORS ten float\n" + data(18) + "TENSORS6 ten6 float\n" + data(12) +
        "TEXTURE_COORDINATES tex 2 float\n" + data(4) + "SCALARS s float\nLOOKUP_TABLE default\n" + data(2) +
        "COLOR_SCALARS rgb 3\n" + (binary ? std::string("\x00\x80\xff\x00\x01\x02\n", 7) : "0 0.5 1 -1 7 nan\n") +
        "GLOBAL_IDS ids float\n" + data(2) + "FIELD more 1\nlast 3 2 float\n" + data(6));
    EXPECT_EQ(mesh.preferredField, "s2");
    EXPECT_TRUE(mesh.pointArrays.empty());
    const std::pair<const char*, std::uint32_t> expected[] = {{"s2", 2},   {"vec", 3}, {"nor", 3}, {"ten", 9},
                                                              {"ten6", 6}, {"tex", 2}, {"s", 1},   {"rgb", 3},
                                                              {"ids", 1},  {"last", 3}};
    ASSERT_EQ(mesh.cellArrays.size(), std::size(expected));
    for (size_t i = 0; i < mesh.cellArrays.size(); i++) {
      EXPECT_EQ(mesh.cellArrays[i].name, expected[i].first);
      EXPECT_EQ(mesh.cellArrays[i].components, expected[i].second);
      if (mesh.cellArrays[i].name == "rgb") continue;
      for (size_t k = 0; k < mesh.cellArrays[i].size(); k++)
        EXPECT_EQ(mesh.cellArrays[i].value(0, static_cast<std::uint32_t>(k)), numbers[k]);
    }
    const auto& colors = std::get<std::vector<std::uint8_t>>(mesh.cellArrays[7].values);
    EXPECT_EQ(colors, binary ? (std::vector<std::uint8_t>{0, 128, 255, 0, 1, 2})
                             : (std::vector<std::uint8_t>{0, 128, 255, 0, 255, 0}));
  }
}

TEST(ReadLegacyVtk, BitsAndStringsArePassedOver) {
  const std::string longString(100, 'x');
  for (const bool binary : {false, true}) {
    const LegacyFormat format{binary, false, false};
    std::string strings = "one%20two\n\n" + longString + "\nfour\nfive\n";
    // Lengths in 1, 2, 4 and 8 bytes, by the two upper bits of the first: 3, 2, 1, 0.
    if (binary)
      strings = "\xc3one" + std::string("\x80\x64", 2) + longString + std::string("\x40\0\0\x04", 4) + "four" +
                std::string("\0\0\0\0\0\0\0\x01", 8) + "5" + "\xc0\n";
    const TetMesh mesh =
        readText(legacyGrid(tinyMesh(), format) + "POINT_DATA 5\nSCALARS flags bit\nLOOKUP_TABLE default\n" +
                 (binary ? "\xa8\n" : "1 0 1 0 1\n") + "FIELD FieldData 2\nwords 1 5 string\n" + strings +
                 "n 1 5 int\n" + legacyNumbers(std::vector<std::int32_t>{1, 2, 3, 4, 5}, format));
    ASSERT_EQ(mesh.pointArrays.size(), 1u);
    EXPECT_EQ(mesh.pointArrays[0].values, ArrayValues(std::vector<std::int32_t>{1, 2, 3, 4, 5}));
    EXPECT_EQ(mesh.preferredField, "");
  }
}

TEST(ReadLegacyVtk, DosLineEndsAndLowerCaseAreUnderstood) {
  std::string text;
  for (const char c : buildLegacy(tinyMesh(), {false, false, true}))
    text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expectEqual(readText(text), tinyMesh());
  expectEqual(
      readText(replaced(replaced(buildLegacy(tinyMesh(), {}), "DATASET UNSTR", "dataset unstr"), "POINTS", "points")),
      tinyMesh());
}

TEST(ReadLegacyVtk, EveryTruncationIsRefusedUnlessItEndsBetweenSections) {
  const TempDir dir;
  for (const LegacyFormat& format : allFormats()) {
    const std::string grid = legacyGrid(tinyMesh(), format);
    const std::string text = grid + legacyArrays(tinyMesh(), format);
    const std::filesystem::path path = dir.write("m.vtk", text);
    for (size_t size = text.size(); size-- > 0;) {
      std::filesystem::resize_file(path, size);
      try {
        const TetMesh mesh = readLegacyVtk(path);
        // The format has no end mark: a file may end after any section, and a number may lose its last digits.
        ASSERT_GE(size + 130, grid.size());
        EXPECT_EQ(mesh.cells, tinyMesh().cells);
        ASSERT_LE(mesh.pointArrays.size(), 2u);
        for (const DataArray& array : mesh.pointArrays) EXPECT_EQ(array.tuples(), 5u);
      } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::Input);
      }
    }
  }
}

TEST(ReadLegacyVtk, ADamagedByteIsRefusedOrReadButNeverMore) {
  const TempDir dir;
  std::mt19937 random(21);
  for (const LegacyFormat& format : allFormats()) {
    const std::string text = buildLegacy(tinyMesh(), format);
    for (int i = 0; i < 400; i++) {
      std::string damaged = text;
      const size_t at = random() % text.size();
      damaged[at] = static_cast<char>(random());
      SCOPED_TRACE(fmt::format("byte {} is {}", at, static_cast<int>(damaged[at])));
      try {
        readLegacyVtk(dir.write("m.vtk", damaged));
      } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::Input);
      }
    }
  }
}

struct Edit {
  const char* from;
  const char* to;
  const char* message;
};

void expectErrors(const std::string& text, const std::vector<Edit>& edits) {
  for (const Edit& edit : edits) EXPECT_EQ(readError(replaced(text, edit.from, edit.to)), edit.message) << edit.to;
}

TEST(ReadLegacyVtk, EveryHeaderFieldIsChecked) {
  expectErrors(
      buildLegacy(tinyMesh(), {}),
      {
          {"# vtk", "# VTK",
           "m.vtk: line 1: '# VTK DataFile Version 4.2', expected '# vtk DataFile Version 5.1' or an earlier one"},
          {"Version 4.2", "Version 6.0", "m.vtk: line 1: version '6.0', expected 1 to 5"},
          {"Version 4.2", "Version ", "m.vtk: line 1: version '', expected 1 to 5"},
          {"ASCII", "TEXT", "m.vtk: line 3: 'TEXT', expected ASCII or BINARY"},
          {"DATASET", "DATA", "m.vtk: line 4: 'data', expected DATASET"},
          {"UNSTRUCTURED_GRID", "POLYDATA", "m.vtk: line 4: DATASET is 'polydata', expected UNSTRUCTURED_GRID"},
          {"POINTS 5", "SPOTS 5",
           "m.vtk: line 5: keyword 'spots', expected POINTS, CELLS, CELL_TYPES, POINT_DATA, CELL_DATA or an array's"},
          {"POINTS 5", "POINTS five", "m.vtk: line 5: 'five', expected the number of points"},
          {"POINTS 5", "POINTS 4",
           "m.vtk: line 8: keyword '4', expected POINTS, CELLS, CELL_TYPES, POINT_DATA, CELL_DATA or an array's"},
          {"POINTS 5", "POINTS 6", "m.vtk: POINTS: value 15 is 'CELLS', expected a number of type Float32"},
          {"POINTS 5", "POINTS 9999999999", "m.vtk: POINTS: 9999999999 points, expected no more than 4294967295"},
          {"POINTS 5", "POINTS 4000000000", "m.vtk: POINTS: 268 characters are left, expected 12000000000 values"},
          {"5 float", "5 real",
           "m.vtk: POINTS: type 'real', expected char, short, int, long, vtktypeint64, float, double or the like"},
          {"5 float", "5 bit", "m.vtk: POINTS: type 'bit', expected a number type"},
          {"CELLS 2 10", "CELLS two 10", "m.vtk: line 9: 'two', expected the number of cells"},
          {"CELLS 2 10", "CELLS 2 -10", "m.vtk: line 9: '-10', expected the size of the cell list"},
          {"CELLS 2 10", "CELLS 3 10", "m.vtk: CELL_TYPES: 2 types, expected the number of cells, 3"},
          {"CELLS 2 10", "CELLS 2 9",
           "m.vtk: line 11: keyword '4', expected POINTS, CELLS, CELL_TYPES, POINT_DATA, CELL_DATA or an array's"},
          {"CELLS 2 10", "CELLS 2 11", "m.vtk: CELLS: value 10 is 'CELL_TYPES', expected a number of type Int32"},
          {"4 0 1 2 3", "3 0 1 2 3", "m.vtk: cell 0: 3 vertices, expected 4"},
          {"4 0 1 2 3", "4 0 1 2 5", "m.vtk: cell 0: vertex index 5, expected below the number of points, 5"},
          {"4 0 1 2 3", "4 0 1 -2 3", "m.vtk: cell 0: vertex index -2, expected below the number of points, 5"},
          {"CELL_TYPES 2", "CELL_TYPES 1", "m.vtk: CELL_TYPES: 1 types, expected the number of cells, 2"},
          {"10 10", "10 14",
           "m.vtk: cell 1: cell type 14 (pyramid), expected 10 (tetrahedron); other cells are not read yet"},
          {"POINT_DATA 5", "POINT_DATA 6", "m.vtk: POINT_DATA: 6 tuples, expected the number of points, 5"},
          {"CELL_DATA 2", "CELL_DATA 0", "m.vtk: CELL_DATA: 0 tuples, expected the number of cells, 2"},
          {"SCALARS a float", "SCALARS a float x", "m.vtk: line 15: 'x', expected LOOKUP_TABLE"},
          {"SCALARS a float", "SCALARS a float 0", "m.vtk: point array 'a': 0 components, expected at least 1"},
          {"LOOKUP_TABLE default", "", "m.vtk: line 17: '0.5', expected LOOKUP_TABLE"},
          {"0.5 1.25", "0.5 1,25", "m.vtk: point array 'a': value 1 is '1,25', expected a number of type Float32"},
          {"FIELD FieldData 1", "FIELD FieldData 2", "m.vtk: line 24: 'FIELD', expected the number of tuples"},
          {"v 3 5 double", "v 3 4 double", "m.vtk: point array 'v': 4 tuples, expected 5"},
          {"v 3 5 double", "v 1000000000000000000 5 double",
           "m.vtk: point array 'v': 1000000000000000000 components, expected at least 1"},
      });
}

TEST(ReadLegacyVtk, CellListsOfBothVersionsAreChecked) {
  expectErrors(
      buildLegacy(tinyMesh(), {false, true}),
      {
          {"CELLS 3 8", "CELLS 4 8", "m.vtk: OFFSETS: value 3 is 'CONNECTIVITY', expected a number of type Int64"},
          {"CELLS 3 8", "CELLS 2 8", "m.vtk: line 11: '8', expected CONNECTIVITY"},
          {"CELLS 3 8", "CELLS 3 7",
           "m.vtk: line 14: keyword '4', expected POINTS, CELLS, CELL_TYPES, POINT_DATA, CELL_DATA or an "
           "array's"},
          {"OFFSETS vtktypeint64", "OFFSETS string", "m.vtk: OFFSETS: type 'string', expected a number type"},
          {"OFFSETS vtktypeint64", "OFFSETS double", "m.vtk: offsets of type Float64, expected an integer type"},
          {"0 4 8", "1 4 8", "m.vtk: OFFSETS: the first is 1, expected 0"},
          {"0 4 8", "0 3 8", "m.vtk: cell 0: ends after vertex 3 of the connectivity, expected 4"},
      });
  // Sizes that are wrong together.
  const std::string counted = buildLegacy(tinyMesh(), {});
  EXPECT_EQ(readError(replaced(replaced(counted, "CELLS 2 10", "CELLS 2 11"), "\n1 2 3 4\n", "\n1 2 3 4 9\n")),
            "m.vtk: CELLS: 11 numbers, expected 10 for 2 cells");
  EXPECT_EQ(readError(replaced(replaced(counted, "CELLS 2 10", "CELLS 2 5"), " 4\n1 2 3 4\n", "\n")),
            "m.vtk: CELLS: 5 numbers hold 1 cells, expected 2");
  EXPECT_EQ(readError(replaced(replaced(counted, "CELLS 2 10", "CELLS 2 9"), "\n1 2 3 4\n", "\n1 2 3\n")),
            "m.vtk: cell 1: 3 vertices are left in the list, expected 4");
}

TEST(ReadLegacyVtk, BinarySectionsAreChecked) {
  const std::string text = buildLegacy(tinyMesh(), {true, false, false});
  expectErrors(text,
               {
                   {"POINTS 5 float", "POINTS 5 double",
                    "m.vtk: byte 207: keyword 'pes', expected POINTS, CELLS, CELL_TYPES, POINT_DATA, CELL_DATA or an "
                    "array's"},
                   {"POINTS 5 float", "POINTS 50 float", "m.vtk: POINTS: data ends after 407 bytes, expected 600"},
                   {"POINTS 5 float", "POINTS 4000000000 double",
                    "m.vtk: POINTS: data ends after 407 bytes, expected 96000000000"},
                   {"CELLS 2 10", "CELLS 2 1000000000000000000",
                    "m.vtk: CELLS: data ends after 335 bytes, expected 4000000000000000000"},
                   {"CELLS 2 10", "CELLS 2 9000000000000000000",
                    "m.vtk: CELLS: 9000000000000000000 tuples of 1 components, expected fewer"},
                   {"v 3 5 double", "v 3 5 string",
                    "m.vtk: point array 'v': data ends after 162 bytes, expected 4607182418800017408"},
               });
  // A wrong byte order shows in the first number that has a limit.
  std::string swapped = text;
  const size_t cells = swapped.find("CELLS 2 10\n") + 11;
  std::reverse(swapped.begin() + static_cast<std::ptrdiff_t>(cells),
               swapped.begin() + static_cast<std::ptrdiff_t>(cells + 4));
  EXPECT_EQ(readError(swapped), "m.vtk: cell 0: 67108864 vertices, expected 4");
}

TEST(ReadLegacyVtk, AFileWithoutCellsIsRefused) {
  EXPECT_EQ(readError("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 float\n0 0 0\n"),
            "m.vtk: no cells, expected at least 1 tetrahedron");
  EXPECT_EQ(readError("# vtk DataFile Version 3.0\nt\nASCII\n"), "m.vtk: line 4: '', expected DATASET");
}

}  // namespace
}  // namespace tetralux
