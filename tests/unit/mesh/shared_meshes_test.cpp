// The shared meshes: their figures as published beside them, and one mesh in many encodings.
#include <gtest/gtest.h>

#include "mesh/mesh_io.h"
#include "mesh/mesh_stats.h"
#include "support/shared_data.h"
#include "support/temp_dir.h"
#include "unit/mesh/mesh_io_fixtures.h"

namespace tetralux {
namespace {

using namespace test;

struct Figures {
  const char* file;
  std::uint64_t points, cells, boundaryFaces;
  glm::dvec3 low, high;
  const char* field;
  double fieldLow, fieldHigh;
  double longestEdge, edgeRatio;
  std::uint64_t zeroVolume, inverted, repeatedVertex;
  double volume;
};

const Figures kFigures[] = {
    {"bluntfin.vtu",
     40960,
     187395,
     13516,
     {-7.8158, 0, 0},
     {14.362, 8.3276, 5.7242},
     "Density",
     0.1926,
     4.9775,
     3.649,
     5389,
     77,
     0,
     0,
     931.163},
    {"combustor.vtu",
     47025,
     215040,
     15616,
     {0, -5.6621, 23.331},
     {16.51, 5.6621, 36.195},
     "Density",
     0.1978131,
     0.7104192,
     0.8597,
     8.254,
     0,
     2,
     0,
     1061.7},
    {"oxygenpost.vtu",
     109744,
     513375,
     27676,
     {-14.987, -14.997, 0},
     {15, 14.997, 4.8205},
     "VelocityMagnitude",
     0,
     1.391444,
     3.15,
     3745,
     0,
     0,
     0,
     3399.66},
    {"spx.vtu",
     2896,
     12936,
     2764,
     {4.0607, 0, -8.67},
     {10, 6.9466, 0.725},
     "density",
     0.2,
     1,
     1.12,
     19.76,
     1,
     11,
     1,
     118.379},
    {"neghip.vtu", 262144, 1250235, 47628, {0, 0, 0}, {63, 63, 63}, "Scalar", 0, 255, 1.414, 1.414, 0, 0, 0, 250047},
};

class SharedMesh : public ::testing::TestWithParam<Figures> {};

TEST_P(SharedMesh, AgreesWithItsPublishedFigures) {
  const Figures& expected = GetParam();
  const std::string file = std::string("data/") + expected.file;
  REQUIRE_SHARED(file);
  const TetMesh mesh = readMesh(sharedPath(file));
  const MeshStats stats = computeMeshStats(mesh);
  // Published with four to seven digits.
  const auto expectNear = [](double actual, double published) {
    EXPECT_NEAR(actual, published, 5e-4 * std::abs(published));
  };
  EXPECT_EQ(stats.points, expected.points);
  EXPECT_EQ(stats.unusedPoints, 0u);
  EXPECT_EQ(stats.cells, expected.cells);
  for (int axis = 0; axis < 3; axis++) {
    expectNear(stats.bounds.low[axis], expected.low[axis]);
    expectNear(stats.bounds.high[axis], expected.high[axis]);
  }
  EXPECT_EQ(mesh.preferredField, expected.field);
  ASSERT_EQ(stats.arrays.size(), 1u);
  EXPECT_EQ(stats.arrays[0].name, expected.field);
  EXPECT_EQ(stats.arrays[0].type, "Float32");
  expectNear(stats.arrays[0].low, expected.fieldLow);
  expectNear(stats.arrays[0].high, expected.fieldHigh);
  expectNear(stats.longestEdge, expected.longestEdge);
  expectNear(stats.longestEdge / stats.shortestEdge, expected.edgeRatio);
  EXPECT_EQ(stats.zeroVolumeCells, expected.zeroVolume);
  EXPECT_EQ(stats.invertedCells, expected.inverted);
  EXPECT_EQ(stats.repeatedVertexCells, expected.repeatedVertex);
  EXPECT_EQ(stats.duplicateCells, 0u);
  expectNear(stats.totalVolume, expected.volume);
  EXPECT_EQ(stats.boundaryFaces, expected.boundaryFaces);
  EXPECT_EQ(stats.overusedFaces, 0u);
  EXPECT_EQ(stats.boundaryFaces + 2 * stats.interiorFaces, 4 * stats.cells);
}

INSTANTIATE_TEST_SUITE_P(All, SharedMesh, ::testing::ValuesIn(kFigures), [](const auto& test) {
  const std::string file = test.param.file;
  return file.substr(0, file.find('.'));
});

TetMesh sharedMesh(const std::string& name) { return readMesh(sharedPath("data/" + name)); }

class SameMeshInFormat : public ::testing::TestWithParam<const char*> {};

TEST_P(SameMeshInFormat, IsTheSame) {
  const std::string file = std::string("formats/") + GetParam();
  REQUIRE_SHARED("data/" + file);
  expectEqual(sharedMesh(file), sharedMesh("spx.vtu"));
}

INSTANTIATE_TEST_SUITE_P(All, SameMeshInFormat,
                         ::testing::Values("spx_appended_base64_nocomp.vtu", "spx_appended_base64_zlib.vtu",
                                           "spx_appended_raw_lz4.vtu", "spx_appended_raw_lzma.vtu",
                                           "spx_appended_raw_nocomp.vtu", "spx_appended_raw_zlib_blocks1000.vtu",
                                           "spx_appended_raw_zlib_int32ids.vtu", "spx_appended_raw_zlib_uint64hdr.vtu",
                                           "spx_ascii.vtu", "spx_bigendian_appended_base64.vtu",
                                           "spx_binary_inline.vtu", "spx_binary_inline_zlib.vtu",
                                           "spx_legacy_binary_v42.vtk", "spx_legacy_binary_v51.vtk"));

// VTK writes six digits in the legacy format's text.
TEST(SharedFormats, LegacyTextIsTheSameMeshToSixDigits) {
  for (const char* name : {"spx_legacy_ascii_v42.vtk", "spx_legacy_ascii_v51.vtk"}) {
    const std::string file = std::string("formats/") + name;
    REQUIRE_SHARED("data/" + file);
    const TetMesh mesh = sharedMesh(file);
    const TetMesh expected = sharedMesh("spx.vtu");
    EXPECT_EQ(mesh.cells, expected.cells);
    EXPECT_EQ(mesh.preferredField, "density");
    ASSERT_EQ(mesh.pointCount(), expected.pointCount());
    ASSERT_EQ(mesh.pointArrays.size(), 1u);
    for (size_t i = 0; i < mesh.pointCount(); i++) {
      for (int axis = 0; axis < 3; axis++) {
        const double exact = expected.point(i)[axis];
        ASSERT_NEAR(mesh.point(i)[axis], exact, 6e-6 * std::abs(exact));
      }
      const double exact = expected.pointArrays[0].value(i);
      ASSERT_NEAR(mesh.pointArrays[0].value(i), exact, 6e-6 * exact);
    }
  }
}

TEST(SharedFormats, DoublePointsHaveTheSamePlaces) {
  REQUIRE_SHARED("data/formats/spx_float64_points.vtu");
  expectEqual(sharedMesh("formats/spx_float64_points.vtu"), withDoublePoints(sharedMesh("spx.vtu")));
}

TEST(SharedFormats, DoubleScalarsHaveTheSameValues) {
  REQUIRE_SHARED("data/formats/spx_float64_scalar.vtu");
  TetMesh expected = sharedMesh("spx.vtu");
  const auto& floats = std::get<std::vector<float>>(expected.pointArrays[0].values);
  expected.pointArrays[0].values = std::vector<double>(floats.begin(), floats.end());
  expectEqual(sharedMesh("formats/spx_float64_scalar.vtu"), expected);
}

TEST(SharedFormats, ByteScalarsAreTheRoundedValues) {
  REQUIRE_SHARED("data/formats/spx_uint8_scalar.vtu");
  TetMesh expected = sharedMesh("spx.vtu");
  std::vector<std::uint8_t> bytes;
  for (const float f : std::get<std::vector<float>>(expected.pointArrays[0].values))
    bytes.push_back(static_cast<std::uint8_t>(std::lround(200.0 * static_cast<double>(f))));
  expected.pointArrays[0] = {"density_u8", 1, bytes};
  expected.preferredField = "density_u8";
  expectEqual(sharedMesh("formats/spx_uint8_scalar.vtu"), expected);
}

TEST(SharedFormats, ManyArraysOfPointsAndCells) {
  REQUIRE_SHARED("data/formats/spx_many_arrays.vtu");
  const TetMesh mesh = sharedMesh("formats/spx_many_arrays.vtu");
  const TetMesh spx = sharedMesh("spx.vtu");
  EXPECT_TRUE(mesh.points == spx.points);
  EXPECT_EQ(mesh.cells, spx.cells);
  EXPECT_EQ(mesh.preferredField, "");
  ASSERT_EQ(mesh.pointArrays.size(), 3u);
  EXPECT_TRUE(mesh.pointArrays[0].values == spx.pointArrays[0].values);
  EXPECT_EQ(mesh.pointArrays[1].name, "other");
  EXPECT_EQ(mesh.pointArrays[2].name, "vel");
  EXPECT_EQ(mesh.pointArrays[2].components, 3u);
  ASSERT_EQ(mesh.cellArrays.size(), 1u);
  for (size_t i = 0; i < mesh.cellCount(); i++) ASSERT_EQ(mesh.cellArrays[0].value(i), static_cast<double>(i));
}

TEST(SharedFormats, OtherCellsAreNamed) {
  const std::pair<const char*, const char*> files[] = {{"mixed_cells.vtu", "11 (voxel)"},
                                                       {"mixed_cells_ascii.vtu", "11 (voxel)"},
                                                       {"disk_out_ref_hex.vtu", "12 (hexahedron)"}};
  for (const auto& [name, type] : files) {
    const std::string file = std::string("data/formats/") + name;
    REQUIRE_SHARED(file);
    EXPECT_EQ(errorOf([&] { readMesh(sharedPath(file)); }),
              sharedPath(file).string() + ": cell 0: cell type " + type +
                  ", expected 10 (tetrahedron); other cells are not read yet");
  }
}

TEST(SharedFormats, AWrittenMeshComesBackEqual) {
  REQUIRE_SHARED("data/formats/spx_many_arrays.vtu");
  const TempDir dir;
  const TetMesh mesh = sharedMesh("formats/spx_many_arrays.vtu");
  writeVtu(mesh, dir / "m.vtu");
  expectEqual(readVtu(dir / "m.vtu"), mesh);
}

}  // namespace
}  // namespace tetralux
