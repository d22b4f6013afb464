// EXR files that cannot be read, and places that cannot be written to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/check.h"
#include "base/files.h"
#include "image/image_io.h"
#include "image_fixtures.h"
#include "support/temp_dir.h"

namespace tetralux {
namespace {

using namespace test;
using ::testing::StartsWith;

std::string tinyExr(const TempDir& dir, ExrCompression compression) {
  writeExr(smoothImage(3, 2), dir / "tiny.exr", {.half = true, .compression = compression});
  return readTextFile(dir / "tiny.exr");
}

// --- Reading ---------------------------------------------------------------------------------------------------------

class ExrTruncation : public ::testing::TestWithParam<ExrCompression> {};

TEST_P(ExrTruncation, AtEveryLengthIsAnInputError) {
  const TempDir dir;
  const std::string whole = tinyExr(dir, GetParam());
  for (size_t length = 0; length < whole.size(); length++) {
    const auto path = dir.write("cut.exr", whole.substr(0, length));
    ASSERT_THAT(errorOf(ErrorCode::Input, [&] { readExr(path); }), StartsWith(path.string() + ": ")) << length;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ExrTruncation,
                         ::testing::Values(ExrCompression::None, ExrCompression::Zip, ExrCompression::Piz,
                                           ExrCompression::B44, ExrCompression::Dwaa),
                         [](const auto& test) { return exrCompressionName(test.param); });

TEST(ReadExr, AnyWrongByteIsAnInputErrorOrAnImage) {
  const TempDir dir;
  const std::string whole = tinyExr(dir, ExrCompression::Zip);
  size_t errors = 0;
  for (size_t i = 0; i < whole.size(); i++) {
    for (const char wrong : {'\x00', '\x01', '\x7f', '\xff'}) {
      std::string content = whole;
      if (content[i] == wrong) continue;
      content[i] = wrong;
      const auto path = dir.write("wrong.exr", content);
      try {
        const Image image = readExr(path);
        EXPECT_EQ(image.pixels.size(), static_cast<size_t>(image.width) * image.height);
      } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::Input);
        EXPECT_THAT(e.what(), StartsWith(path.string() + ": "));
        errors++;
      }
    }
  }
  EXPECT_GT(errors, whole.size());
}

TEST(ReadExr, WhatIsNoFileIsSaidExactly) {
  const TempDir dir;
  const std::string missing = (dir / "missing.exr").string();
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExr(missing); }), missing + ": no such file");
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExr(dir.path()); }),
            dir.path().string() + ": is a directory, expected a file");
  const std::string empty = dir.write("empty.exr", "").string();
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExr(empty); }), empty + ": is empty");
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExrAttribute(missing, "a"); }), missing + ": no such file");
}

TEST(ReadExr, FileOfAnotherFormatIsNamedByItsFirstBytes) {
  const TempDir dir;
  writePng(smoothImage(2, 2), dir / "a.png", glm::vec3(0.0f));
  const std::string renamed = dir.write("a.exr", readTextFile(dir / "a.png")).string();
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExr(renamed); }),
            renamed + ": is not an OpenEXR image: begins with 89 50 4e 47, expected 76 2f 31 01");
  const std::string brief = dir.write("b.exr", "v/").string();
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExrAttribute(brief, "a"); }),
            brief + ": is not an OpenEXR image: begins with 76 2f, expected 76 2f 31 01");
}

TEST(ReadExr, UnknownVersionIsRefused) {
  const TempDir dir;
  std::string content = tinyExr(dir, ExrCompression::None);
  content[4] = 9;
  const std::string path = dir.write("a.exr", content).string();
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExr(path); }),
            path + ": cannot be read as OpenEXR: version field is 0x9, expected version 2");
}

// Puts four bytes, lowest first, in place of the value of the data window's number `index`.
std::string withDataWindow(std::string content, size_t index, std::int32_t value) {
  const std::string name("dataWindow\0box2i\0", 17);
  const size_t begin = content.find(name) + name.size() + 4 + 4 * index;
  for (size_t i = 0; i < 4; i++) content[begin + i] = static_cast<char>(static_cast<std::uint32_t>(value) >> (8 * i));
  return content;
}

TEST(ReadExr, AbsurdSizesAreRefusedWithTheirNumbers) {
  const TempDir dir;
  const std::string whole = tinyExr(dir, ExrCompression::None);
  const auto errorWith = [&](size_t index, std::int32_t value) {
    const auto path = dir.write("a.exr", withDataWindow(whole, index, value));
    return errorOf(ErrorCode::Input, [&] { readExr(path); }).substr(path.string().size());
  };
  const std::string expected = ", expected 1 to 65536 a side and at most 268435456 in all";
  EXPECT_EQ(errorWith(2, 65536), ": is 65537 x 2 pixels" + expected);
  EXPECT_EQ(errorWith(3, 0x7fffffff), ": is 3 x 2147483648 pixels" + expected);
  EXPECT_EQ(errorWith(0, -0x7fffffff - 1), ": is 2147483651 x 2 pixels" + expected);
  EXPECT_EQ(errorWith(2, -1), ": is 0 x 2 pixels" + expected);
  const std::string both = withDataWindow(withDataWindow(whole, 2, 65535), 3, 65535);
  const auto path = dir.write("both.exr", both);
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExr(path); }), path.string() + ": is 65536 x 65536 pixels" + expected);
}

TEST(ReadExr, AttributeLargerThanTheFileIsRefusedBeforeItIsAllocated) {
  const TempDir dir;
  std::string content = tinyExr(dir, ExrCompression::None);
  const std::string name("compression\0compression\0", 24);
  const size_t at = content.find(name) + name.size();
  content[at + 3] = '\x7f';
  const std::string path = dir.write("a.exr", content).string();
  const std::string expected =
      fmt::format(": cannot be read as OpenEXR: attribute 'compression' has {} bytes, but the file only {} more",
                  0x7f000001, content.size() - at - 4);
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExr(path); }), path + expected);
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExrAttribute(path, "a"); }), path + expected);
}

TEST(ReadExr, MoreLinesClaimedThanThereAreIsAnInputError) {
  const TempDir dir;
  const auto path = dir.write("a.exr", withDataWindow(tinyExr(dir, ExrCompression::None), 3, 4999));
  EXPECT_THAT(errorOf(ErrorCode::Input, [&] { readExr(path); }), StartsWith(path.string() + ": "));
}

// --- Writing ---------------------------------------------------------------------------------------------------------

TEST(WriteExr, PlaceThatCannotBeWrittenIsAnOutputError) {
  const TempDir dir;
  const Image image = smoothImage(2, 2);
  const std::string missing = (dir / "none/a.exr").string();
  EXPECT_EQ(errorOf(ErrorCode::Output, [&] { writeExr(image, missing); }),
            missing + ": no such folder " + (dir / "none").string());
  EXPECT_EQ(errorOf(ErrorCode::Output, [&] { writeExr(image, dir.path()); }),
            dir.path().string() + ": is a directory, expected a file name");
  // A folder in which nobody, not even the superuser, may create files.
  EXPECT_THAT(errorOf(ErrorCode::Output, [&] { writeExr(image, "/proc/a.exr"); }),
              StartsWith("/proc/a.exr: cannot be written: "));
  EXPECT_EQ(dir.entries(), 0u);
}

TEST(WriteExr, FullDiskLeavesTheOldFileAndNothingElse) {
  const TempDir dir;
  const auto path = dir.write("a.exr", "old");
  // Small: the system tells when the file is closed. Large: in the middle of the pixels.
  for (const std::uint32_t side : {4u, 128u}) {
    const Image image = smoothImage(side, side);
    const std::string error = errorOf(ErrorCode::Output, [&] {
      const FullDisk full(200);
      writeExr(image, path, {.compression = ExrCompression::None});
    });
    EXPECT_EQ(error, path.string() + ": cannot be written: File too large") << side;
    EXPECT_EQ(readTextFile(path), "old");
    EXPECT_EQ(dir.entries(), 1u);
  }
}

TEST(WriteExr, DefectsOfTheCallerAreFoundBeforeAnythingIsWritten) {
  const TempDir dir;
  const auto path = dir.write("a.exr", "old");
  const Image image = smoothImage(2, 2);
  EXPECT_THROW(writeExr(image, path, {.extraChannelName = "layers", .extraChannel = {1, 2, 3}}), CheckFailure);
  EXPECT_THROW(writeExr(image, path, {.extraChannel = {1, 2, 3, 4}}), CheckFailure);
  EXPECT_THROW(writeExr(image, path, {.extraChannelName = "R", .extraChannel = {1, 2, 3, 4}}), CheckFailure);
  EXPECT_THROW(writeExr(image, path, {.attributes = {{"compression", "zip"}}}), CheckFailure);
  EXPECT_THROW(writeExr(Image(), path), CheckFailure);
  EXPECT_EQ(readTextFile(path), "old");
  EXPECT_EQ(dir.entries(), 1u);
}

TEST(WriteExr, ExistingFileIsReplaced) {
  const TempDir dir;
  const auto path = dir.write("a.exr", "old");
  writeExr(smoothImage(2, 2), path);
  EXPECT_EQ(largestDifference(readExr(path), smoothImage(2, 2)), 0.0);
  EXPECT_EQ(dir.entries(), 1u);
}

}  // namespace
}  // namespace tetralux
