#include "scene/transfer_file.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/temp_dir.h"

namespace tetralux {
namespace {

using test::errorOf;

TEST(TransferFile, PresetsAreColorMapsFromZeroToOne) {
  const auto names = transferPresetNames();
  EXPECT_GE(names.size(), 4u);
  for (const std::string& name : names) {
    const auto points = transferPreset(name);
    ASSERT_TRUE(points.has_value()) << name;
    EXPECT_EQ(points->front().s, 0.0) << name;
    EXPECT_EQ(points->back().s, 1.0) << name;
    EXPECT_NO_THROW(TransferFunction(*points, name));
    EXPECT_GT(TransferFunction(*points, name).largestExtinction(), 0.0) << name;
  }
  EXPECT_FALSE(transferPreset("none").has_value());
  EXPECT_FALSE(transferPreset("").has_value());
}

TEST(TransferFile, IsReadByItselfOrFromAScene) {
  const test::TempDir dir;
  const std::string points = R"("points": [{"s": 1, "rgb": [0, 0, 1], "tau": 3}])";
  EXPECT_EQ(readTransferFunction(dir.write("a.json", "{" + points + "}")).at(0).extinction, 3.0);
  EXPECT_EQ(readTransferFunction(dir.write("b.json", "{\"mesh\": 1, \"transfer_function\": {" + points + "}}"))
                .at(0)
                .extinction,
            3.0);
  const std::string file = dir.write("c.json", "{" + points + ", \"x\": 1}").string();
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readTransferFunction(file); }),
            file + ": x: unknown key, expected one of emission, points, transfer_function");
}

TEST(TransferFile, EmissionIsPerExtinctionUnlessSaidOtherwise) {
  const test::TempDir dir;
  const auto read = [&](const std::string& emission) {
    return readTransferFunction(
        dir.write("t.json", "{" + emission + R"("points": [{"s": 1, "rgb": [0, 0, 1], "tau": 3}]})"));
  };
  EXPECT_EQ(read("").emission(), Emission::PerExtinction);
  EXPECT_EQ(read("\"emission\": \"per_extinction\", ").emission(), Emission::PerExtinction);
  EXPECT_EQ(read("\"emission\": \"per_length\", ").emission(), Emission::PerLength);
  const std::string file = (dir / "t.json").string();
  const std::string expected = ", expected one of \"per_extinction\", \"per_length\"";
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { read("\"emission\": \"per_metre\", "); }),
            file + ": emission: found \"per_metre\"" + expected);
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { read("\"emission\": 1, "); }), file + ": emission: found 1" + expected);
}

}  // namespace
}  // namespace tetralux
