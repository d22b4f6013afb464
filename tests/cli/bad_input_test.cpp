// Bad input: one clear line, exit status 3 (4 for devices, 5 for outputs), no output file left behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "support/run_program.h"
#include "support/temp_dir.h"

namespace tetralux::cli {
namespace {

using test::runTetralux;
using test::TempDir;
using ::testing::HasSubstr;

const std::string kMesh = R"(<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="1">
<PointData Scalars="s"><DataArray type="Float32" Name="s" format="ascii">0 1 0.5 0.25</DataArray></PointData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>)";

const std::string kScene = R"({"mesh": "m.vtu", "field": "s",
 "camera": {"projection": "perspective", "eye": [3, -4, 2], "center": [0, 0, 0], "up": [0, 0, 1], "fovy": 30},
 "image": {"width": 8, "height": 8},
 "transfer_function": {"points": [{"s": 0, "rgb": [1, 1, 1], "tau": 1}]}})";

std::string edited(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// Runs render and reference; both must fail in the same words and leave nothing.
void expectInputError(const std::string& mesh, const std::string& scene, const std::string& message) {
  for (const char* command : {"render", "reference"}) {
    const TempDir dir;
    if (!mesh.empty()) dir.write("m.vtu", mesh);
    dir.write("s.json", scene);
    const size_t before = dir.entries();
    const auto result = runTetralux({command, "s.json", "-o", "out.exr", "--quiet"}, dir.path());
    EXPECT_EQ(result.status, 3) << result.err;
    EXPECT_EQ(result.err, "tetralux: " + message + "\n");
    EXPECT_EQ(dir.entries(), before);
  }
}

TEST(BadInput, AGoodSceneIsDrawn) {
  const TempDir dir;
  dir.write("m.vtu", kMesh);
  dir.write("s.json", kScene);
  EXPECT_EQ(runTetralux({"render", "s.json", "-o", "out.exr", "--quiet"}, dir.path()).status, 0);
  EXPECT_TRUE(std::filesystem::exists(dir / "out.exr"));
}

TEST(BadInput, ScenesAndMeshes) {
  expectInputError("", kScene, "m.vtu: no such file");
  expectInputError(kMesh, edited(kScene, "\"s\"", "\"t\""), "m.vtu: no array 't', the mesh has 's'");
  expectInputError(kMesh, edited(kScene, "[3, -4, 2]", "[0, 0, 0]"),
                   "s.json: camera: eye and center are both (0, 0, 0), expected two different points");
  expectInputError(
      kMesh, edited(kScene, "\"image\"", "\"images\": 1, \"image\""),
      "s.json: images: unknown key, expected one of boundary_emphasis, camera, clip, field, image, isosurfaces, "
      "lighting, mesh, opacity_by_gradient, rgba_field, second_field, silhouette_emphasis, surfaces, "
      "transfer_function, transfer_function_2d, volume");
  expectInputError(kMesh, edited(kScene, "{\"points\"", "{\"emission\": \"per_area\", \"points\""),
                   "s.json: transfer_function.emission: found \"per_area\", expected one of \"per_extinction\", "
                   "\"per_length\"");
  expectInputError(edited(kMesh, "0 1 0.5 0.25", "0 nan 0.5 0.25"), kScene,
                   "m.vtu: array 's': point 1: value is nan, expected a finite number");
  expectInputError(edited(kMesh, "0 0 0 1 0 0", "0 0 0 nan 0 0"), kScene,
                   "m.vtu: point 1: coordinate x is nan, expected a finite number");
  expectInputError(edited(kMesh, "0 1 2 3", "0 1 2 4"), kScene,
                   "m.vtu: cell 0: vertex index 4, expected below the number of points, 4");
}

TEST(BadInput, FilesThatAreNoMesh) {
  const TempDir dir;
  std::filesystem::create_directory(dir / "folder.vtu");
  dir.write("empty.vtu", "");
  dir.write("half.vtu", kMesh.substr(0, kMesh.size() / 2));
  dir.write("picture.vtu", "\x89PNG\r\n\x1a\n0000");
  dir.write("mesh.abc", kMesh);
  const size_t before = dir.entries();
  const std::pair<const char*, const char*> cases[] = {
      {"none.vtu", "no such file"},     {"folder.vtu", "is a directory, expected a file"},
      {"empty.vtu", "is empty"},        {"half.vtu", "half.vtu: "},
      {"picture.vtu", "picture.vtu: "}, {"mesh.abc", ".vtu"}};
  for (const auto& [name, part] : cases) {
    for (const char* command : {"render", "info", "bench"}) {
      const auto result = runTetralux({command, name}, dir.path());
      EXPECT_EQ(result.status, 3) << command << " " << name << ": " << result.err;
      EXPECT_THAT(result.err, HasSubstr(part));
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }
  }
  EXPECT_EQ(dir.entries(), before);
}

TEST(BadInput, OutputsThatCannotBeWrittenLeaveOldFilesAlone) {
  const TempDir dir;
  dir.write("m.vtu", kMesh);
  dir.write("s.json", kScene);
  dir.write("old.exr", "old");
  const auto result = runTetralux({"render", "s.json", "-o", "none/out.exr", "--quiet"}, dir.path());
  EXPECT_EQ(result.status, 5);
  EXPECT_EQ(result.err, "tetralux: none/out.exr: no such folder none\n");
  EXPECT_EQ(runTetralux({"render", "m.vtu", "--field", "x", "-o", "old.exr", "--quiet"}, dir.path()).status, 3);
  EXPECT_EQ(readTextFile(dir / "old.exr"), "old");
}

// The first frame can be written, the second cannot: it says so, whatever else is being drawn by then.
TEST(BadInput, AFrameThatCannotBeWrittenEndsTheSequence) {
  const TempDir dir;
  dir.write("m.vtu", kMesh);
  dir.write("s.json", kScene);
  std::filesystem::create_directory(dir / "f0");
  for (const char* stats : {"", "s_out.json"}) {
    std::vector<std::string> arguments = {"render", "s.json", "--frames", "9", "-o", "f%d/out.png", "--quiet"};
    if (*stats) arguments.insert(arguments.end(), {"--stats", stats});
    const auto result = runTetralux(arguments, dir.path());
    EXPECT_EQ(result.status, 5);
    EXPECT_EQ(result.err, "tetralux: f1/out.png: no such folder f1\n");
    EXPECT_TRUE(std::filesystem::exists(dir / "f0/out.png"));
    EXPECT_EQ(dir.entries(), 3u);  // mesh, scene, folder
  }
}

TEST(BadInput, TooLittleMemoryIsStatusFour) {
  const TempDir dir;
  dir.write("m.vtu", kMesh);
  for (const char* projection : {"auto", "pt"}) {
    const auto result = runTetralux(
        {"render", "m.vtu", "-o", "out.exr", "--quiet", "--projection", projection, "--force-path", "small-memory"},
        dir.path());
    EXPECT_EQ(result.status, 4);
    EXPECT_THAT(result.err, HasSubstr("out of memory: a mesh of 1 cells needs "));
    EXPECT_THAT(result.err, HasSubstr("has 16 available\n"));
    EXPECT_EQ(dir.entries(), 1u);
  }
}

TEST(BadInput, NoDeviceIsStatusFour) {
  const TempDir dir;
  dir.write("m.vtu", kMesh);
  const auto none = runTetralux({"render", "m.vtu", "-o", "out.exr", "--quiet"}, dir.path(),
                                "VK_ICD_FILENAMES=/nonexistent VK_DRIVER_FILES=/nonexistent");
  EXPECT_EQ(none.status, 4);
  EXPECT_EQ(std::count(none.err.begin(), none.err.end(), '\n'), 1) << none.err;
  const auto other = runTetralux({"render", "m.vtu", "-o", "out.exr", "--quiet", "--device", "nonesuch"}, dir.path());
  EXPECT_EQ(other.status, 4);
  EXPECT_THAT(other.err, HasSubstr("no device matches 'nonesuch', expected one of 0: "));
  EXPECT_FALSE(std::filesystem::exists(dir / "out.exr"));
}

TEST(BadInput, PicturesThatCannotBeCompared) {
  const TempDir dir;
  dir.write("m.vtu", kMesh);
  dir.write("a.exr", "no picture");
  dir.write("a.tif", "no picture");
  EXPECT_EQ(
      runTetralux({"render", "m.vtu", "--size", "8x8", "-o", "b.exr", "-o", "b.png", "--quiet"}, dir.path()).status, 0);
  EXPECT_EQ(runTetralux({"render", "m.vtu", "--size", "8x9", "-o", "c.exr", "--quiet"}, dir.path()).status, 0);
  EXPECT_EQ(runTetralux({"compare", "b.exr", "a.exr"}, dir.path()).status, 3);
  EXPECT_EQ(runTetralux({"compare", "b.exr", "a.tif"}, dir.path()).status, 3);
  EXPECT_EQ(runTetralux({"compare", "b.exr", "none.exr"}, dir.path()).status, 3);
  const auto sizes = runTetralux({"compare", "b.exr", "c.exr"}, dir.path());
  EXPECT_EQ(sizes.status, 3);
  EXPECT_THAT(sizes.err, HasSubstr("8 x 9 pixels, expected 8 x 8"));
}

}  // namespace
}  // namespace tetralux::cli
