#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <limits>
#include <random>

#include "mesh/triangle_mesh.h"
#include "support/expect_error.h"
#include "support/temp_dir.h"
#include "unit/mesh/vtu_builder.h"

namespace tetralux {
namespace {

using test::TempDir;
using Triangle = std::array<std::uint32_t, 3>;

// A square whose last corner is raised, as two triangles: what all files below hold.
const std::vector<glm::dvec3> kPoints = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.25}};
const std::vector<Triangle> kTriangles = {{0, 1, 2}, {0, 2, 3}};

std::string bytesOf(const ArrayValues& values, bool bigEndian = false) { return test::numberBytes(values, bigEndian); }

std::string textStl() {
  std::string text = "solid a square\n";
  for (const Triangle& triangle : kTriangles) {
    text += "facet normal 0 0 1\n outer loop\n";
    for (const auto v : triangle) text += fmt::format("  vertex {} {} {}\n", kPoints[v].x, kPoints[v].y, kPoints[v].z);
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid a square\n";
}

std::string binaryStl() {
  std::string text = "solid, but binary";
  text.resize(80, ' ');
  text += bytesOf(std::vector<std::uint32_t>{2});
  for (const Triangle& triangle : kTriangles) {
    std::vector<float> numbers = {0, 0, 1};
    for (const auto v : triangle) {
      for (int axis = 0; axis < 3; axis++) numbers.push_back(static_cast<float>(kPoints[v][axis]));
    }
    text += bytesOf(numbers) + std::string(2, '\0');
  }
  return text;
}

std::string plyHeader(const char* format) {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment a square\nelement vertex 4\nproperty uchar red\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar int vertex_indices\nproperty double weight\nend_header\n",
      format);
}

std::string textPly() {
  return plyHeader("ascii") + "7 0 0 0\n7 1 0 0\n7 1 1 0\n7 0 1 0.25\n3 0 1 2 0.5\n3 0 2 3 0.5\n";
}

std::string binaryPly(bool bigEndian) {
  std::string text = plyHeader(bigEndian ? "binary_big_endian" : "binary_little_endian");
  for (const glm::dvec3& p : kPoints) {
    text +=
        '\7' + bytesOf(std::vector<float>{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
                       bigEndian);
  }
  for (const Triangle& t : kTriangles) {
    text += '\3' + bytesOf(std::vector<std::uint32_t>(t.begin(), t.end()), bigEndian) +
            bytesOf(std::vector<double>{0.5}, bigEndian);
  }
  return text;
}

std::string obj() {
  return "# a square\nmtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.25\nvn 0 0 1\nf 1 2 3\nf 1//1 3//1 4//1\n";
}

std::string vtp(const std::string& cells =
                    "<Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 "
                    "2 0 2 3</DataArray><DataArray type=\"Int64\" Name=\"offsets\" "
                    "format=\"ascii\">3 6</DataArray></Polys>",
                const std::string& counts = "NumberOfPolys=\"2\"") {
  return "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"4\" " + counts +
         "><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 1 1 0 0 1 0.25"
         "</DataArray></Points>" +
         cells + "</Piece></PolyData></VTKFile>\n";
}

struct File {
  const char* name;
  std::string content;
};

std::vector<File> allFiles() {
  return {{"m.stl", textStl()},       {"b.STL", binaryStl()}, {"m.ply", textPly()}, {"l.ply", binaryPly(false)},
          {"b.ply", binaryPly(true)}, {"m.obj", obj()},       {"m.vtp", vtp()}};
}

TriangleMesh read(const char* name, const std::string& content) {
  const TempDir dir;
  return readTriangleMesh(dir.write(name, content));
}

// The message, with the file's name alone.
std::string readError(const char* name, const std::string& content) {
  const TempDir dir;
  const std::filesystem::path path = dir.write(name, content);
  std::string message = test::errorOf(ErrorCode::Input, [&] { readTriangleMesh(path); });
  const size_t at = message.find(path.string());
  if (at != std::string::npos) message.replace(at, path.string().size(), name);
  return message;
}

std::string edited(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

void expectSquare(const TriangleMesh& mesh) {
  EXPECT_EQ(mesh.points, kPoints);
  EXPECT_EQ(mesh.triangles, kTriangles);
}

TEST(ReadTriangleMesh, AllFormatsHoldTheSameSurface) {
  for (const File& file : allFiles()) {
    SCOPED_TRACE(file.name);
    expectSquare(read(file.name, file.content));
  }
}

TEST(ReadTriangleMesh, VtpInEveryEncodingOfVtu) {
  using test::Compression;
  using test::Placement;
  TetMesh square;
  square.points = std::vector<glm::vec3>(kPoints.begin(), kPoints.end());
  square.cells = {{0, 1, 2, 3}};
  for (const Placement placement :
       {Placement::Ascii, Placement::Inline, Placement::AppendedRaw, Placement::AppendedBase64}) {
    for (const Compression compression : {Compression::None, Compression::ZLib, Compression::Lz4, Compression::Lzma}) {
      test::VtuFormat format;
      format.placement = placement;
      format.compression = compression;
      format.bigEndian = placement == Placement::Inline;
      // A cell of four vertices is a square where cells are polygons.
      std::string text = test::buildVtu(square, format);
      for (const char* tag : {"UnstructuredGrid\" v", "<UnstructuredGrid>", "</UnstructuredGrid>"})
        text = edited(text, tag, edited(tag, "UnstructuredGrid", "PolyData"));
      text = edited(edited(text, "<Cells>", "<Polys>"), "</Cells>", "</Polys>");
      expectSquare(read("m.vtp", edited(text, "NumberOfCells", "NumberOfPolys")));
    }
  }
}

TEST(ReadTriangleMesh, PolygonsBecomeFans) {
  expectSquare(read("m.obj", edited(obj(), "f 1 2 3\nf 1//1 3//1 4//1", "f 1 2 3 4")));
  expectSquare(read("m.obj", edited(obj(), "f 1 2 3\nf 1//1 3//1 4//1", "f -4/1/1 -3/1/1 -2 -1")));
  expectSquare(read("m.ply", edited(edited(textPly(), "face 2", "face 1"), "3 0 1 2 0.5\n3 0 2 3 0.5", "4 0 1 2 3 1")));
}

TEST(ReadTriangleMesh, StripsTurnEveryOtherTriangle) {
  const std::string strip =
      "<Strips><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">1 2 0 3</DataArray><DataArray "
      "type=\"Int32\" Name=\"offsets\" format=\"ascii\">4</DataArray></Strips>";
  const TriangleMesh mesh = read("m.vtp", vtp(strip, "NumberOfStrips=\"1\""));
  // Points are numbered as triangles come to them: 1, 2, 0, 3 of the file.
  EXPECT_EQ(mesh.points, (std::vector<glm::dvec3>{kPoints[1], kPoints[2], kPoints[0], kPoints[3]}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
}

TEST(ReadTriangleMesh, PointsAtOnePlaceAreOneAndUnusedOnesGo) {
  const TriangleMesh mesh =
      read("m.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 -0\nv 1 1 0\nf 2 3 4\nf 5 7 6\nf 3 5 2\n");
  EXPECT_EQ(mesh.points, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(ReadTriangleMesh, PointsAndLinesAreLeftOut) {
  expectSquare(read("m.obj", obj() + "l 1 2\np 3\n"));
  expectSquare(read("m.ply", edited(textPly(), "property double weight\n",
                                    "property double weight\nelement edge 1\nproperty int vertex1\nproperty list "
                                    "uchar float z\n") +
                                 "1 2 0.5 0.25\n"));
  expectSquare(read("m.vtp", edited(vtp(), "NumberOfPolys", "NumberOfLines=\"1\" NumberOfPolys")));
}

TEST(ReadTriangleMesh, DoubleCoordinatesKeepTheirDigits) {
  EXPECT_EQ(read("m.obj", edited(obj(), "v 1 0 0", "v 1.0000000000001 0 0")).points.at(1).x, 1.0000000000001);
}

TEST(ReadTriangleMesh, EveryTruncationIsRefusedUnlessWhatIsLeftIsComplete) {
  for (const File& file : allFiles()) {
    SCOPED_TRACE(file.name);
    const TempDir dir;
    for (size_t size = file.content.size(); size-- > 0;) {
      const auto path = dir.write(file.name, file.content.substr(0, size));
      try {
        const TriangleMesh mesh = readTriangleMesh(path);
        // Text without its last line's end or last digits; .obj files do not say how much they hold.
        const bool isObj = std::string(file.name) == "m.obj";
        ASSERT_TRUE(isObj || size + 16 > file.content.size()) << "read a file of " << size << " bytes";
        ASSERT_EQ(mesh.triangles,
                  std::vector<Triangle>(kTriangles.begin(), kTriangles.begin() + std::ssize(mesh.triangles)));
      } catch (const Error& e) {
        ASSERT_EQ(e.code(), ErrorCode::Input);
      }
    }
  }
}

TEST(ReadTriangleMesh, ADamagedByteIsRefusedOrReadButNeverMore) {
  std::mt19937 random(20);
  for (const File& file : allFiles()) {
    const TempDir dir;
    for (int i = 0; i < 300; i++) {
      std::string damaged = file.content;
      const size_t at = random() % damaged.size();
      damaged[at] = static_cast<char>(random());
      SCOPED_TRACE(fmt::format("{}: byte {} is {}", file.name, at, static_cast<int>(damaged[at])));
      try {
        readTriangleMesh(dir.write(file.name, damaged));
      } catch (const Error& e) {
        ASSERT_EQ(e.code(), ErrorCode::Input);
      }
    }
  }
}

struct Edit {
  const char* file;
  const char* from;
  const char* to;
  const char* message;
};

TEST(ReadTriangleMesh, MessagesGivePlaceValueFoundAndValueExpected) {
  const Edit edits[] = {
      {"m.stl", "vertex 1 0 0", "vertex 1 x 0", "m.stl: line 5: 'x', expected a number"},
      {"m.stl", "vertex 1 0 0", "vertex nan 0 0", "m.stl: point 1: coordinate x is nan, expected a finite number"},
      {"m.stl", " endloop", "  vertex 0 0 0", "m.stl: line 7: 'vertex', expected 'endloop'"},
      {"m.stl", "endsolid a square\n", "", "m.stl: the file ends, expected 'endsolid'"},
      {"m.stl", "solid", "liquid", "m.stl: 225 bytes, expected "},
      {"m.ply", "ply", "plx", "m.ply: line 1: 'plx', expected 'ply'"},
      {"m.ply", "ascii", "text", "m.ply: line 2: 'text', expected ascii, binary_little_endian or binary_big_endian"},
      {"m.ply", "float x", "half x", "m.ply: line 6: 'half', expected char to uint, int8 to uint32, float or double"},
      {"m.ply", "float x", "float u", "m.ply: no property 'x' of vertices, expected one"},
      {"m.ply", "vertex_indices", "corners", "m.ply: no list 'vertex_indices' of faces, expected one"},
      {"m.ply", "vertex 4", "vertex -4", "m.ply: line 4: '-4', expected a whole number"},
      {"m.ply", "vertex 4", "vertex 5000000000", "m.ply: 5000000000 points, expected no more than 4294967295"},
      {"m.ply", "vertex 4", "vertex 4000000000", "m.ply: vertex 5: '0.5', expected a number"},
      {"m.ply", "face 2", "face 3", "m.ply: face 2: the file ends, expected a number"},
      {"m.ply", "face 2", "face 1", "m.ply: '3' after the last element, expected the file's end"},
      {"m.ply", "3 0 2 3", "3 0 2 4", "m.ply: face 1: vertex index 4, expected below the number of points, 4"},
      {"m.ply", "3 0 2 3", "3 0 2 -1", "m.ply: face 1: vertex index -1, expected below the number of points, 4"},
      {"m.ply", "3 0 2 3", "2 0 2", "m.ply: face 1: 2 vertices, expected at least 3"},
      {"m.ply", "end_header", "end_head", "m.ply: line 12: 'end_head', expected element, property or end_header"},
      {"m.obj", "v 1 0 0", "v 1 0", "m.obj: line 4: coordinate z is '', expected a number"},
      {"m.obj", "f 1 2 3", "f 1 2", "m.obj: line 8: 2 vertices, expected at least 3"},
      {"m.obj", "f 1 2 3", "f 1 2 9", "m.obj: line 8: vertex index 8, expected below the number of points, 4"},
      {"m.obj", "f 1 2 3", "f 1 2 0", "m.obj: line 8: corner '0', expected the number of a point"},
      {"m.obj", "f 1 2 3", "f 1 2 -5", "m.obj: line 8: corner '-5', expected one of the 4 points before it"},
      {"m.obj", "v 0 0 0", "v inf 0 0", "m.obj: point 0: coordinate x is inf, expected a finite number"},
      {"m.vtp", "3 6", "3 5", "m.vtp: piece 0: Polys: connectivity: '3' after the last value, expected 5 values"},
      {"m.vtp", "3 6", "3 2",
       "m.vtp: piece 0: Polys: cell 1: ends after vertex 2 of the connectivity, expected at least 3"},
      {"m.vtp", "2 0 2 3", "2 0 2 7",
       "m.vtp: piece 0: Polys: cell 1: vertex index 7, expected below the number of points, 4"},
      {"m.vtp", "Int64", "Float32", "m.vtp: piece 0: Polys: connectivity: type is Float32, expected an integer type"},
      {"m.vtp", "\"connectivity\"", "\"c\"", "m.vtp: piece 0: Polys: no array 'connectivity', expected one"},
      {"m.vtp", "type=\"PolyData\"", "type=\"UnstructuredGrid\"",
       "m.vtp: VTKFile type is 'UnstructuredGrid', expected 'PolyData'"},
      {"m.vtp", "0 1 0.25", "0 1 nan", "m.vtp: point 3: coordinate z is nan, expected a finite number"},
  };
  for (const Edit& edit : edits) {
    for (const File& file : allFiles()) {
      if (std::string(file.name) != edit.file) continue;
      const std::string message = readError(file.name, edited(file.content, edit.from, edit.to));
      EXPECT_EQ(message.substr(0, std::string(edit.message).size()), edit.message) << message;
    }
  }
}

TEST(ReadTriangleMesh, SizesOfBinaryStlAreChecked) {
  EXPECT_EQ(readError("m.stl", std::string(80, 'x') + bytesOf(std::vector<std::uint32_t>{3}) + std::string(100, ' ')),
            "m.stl: 184 bytes, expected 234 for the 3 triangles that it says it has");
  EXPECT_EQ(readError("m.stl", "surface"),
            "m.stl: 7 bytes that begin with 'surface', expected 'solid', or the 84 bytes of a binary header");
}

TEST(ReadTriangleMesh, NoTrianglesIsAnError) {
  const char* expected = ": no triangle whose corners differ, expected at least one";
  EXPECT_EQ(readError("m.stl", "solid\nendsolid\n"), std::string("m.stl") + expected);
  EXPECT_EQ(readError("m.stl", std::string(84, '\0')), std::string("m.stl") + expected);
  EXPECT_EQ(readError("m.obj", "v 0 0 0\n"), std::string("m.obj") + expected);
  EXPECT_EQ(readError("m.obj", "v 0 0 0\nv 0 0 1\nf 1 2 2\n"), std::string("m.obj") + expected);
  EXPECT_EQ(readError("m.vtp", vtp("", "")), std::string("m.vtp") + expected);
}

TEST(ReadTriangleMesh, OtherNamesAreRefused) {
  EXPECT_EQ(readError("m.vtu", "x"), "m.vtu: file name ends in '.vtu', expected .stl, .ply, .obj or .vtp");
  EXPECT_EQ(test::errorOf(ErrorCode::Input, [] { readTriangleMesh("none.stl"); }), "none.stl: no such file");
}

}  // namespace
}  // namespace tetralux
