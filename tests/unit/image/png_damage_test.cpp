// PNG files that cannot be read, and places that cannot be written to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "base/check.h"
#include "base/files.h"
#include "image/image_io.h"
#include "image_fixtures.h"
#include "png_samples.h"
#include "support/temp_dir.h"

namespace tetralux {
namespace {

using namespace test;
using ::testing::StartsWith;

std::string tinyPng(const TempDir& dir) {
  writePng(smoothImage(3, 2), dir / "tiny.png", glm::vec3(0.0f));
  return readTextFile(dir / "tiny.png");
}

// --- Reading ---------------------------------------------------------------------------------------------------------

TEST(ReadPng, TruncationAtEveryLengthIsAnInputError) {
  const TempDir dir;
  const std::string whole = tinyPng(dir);
  for (size_t length = 0; length < whole.size(); length++) {
    const auto path = dir.write("cut.png", whole.substr(0, length));
    ASSERT_THAT(errorOf(ErrorCode::Input, [&] { readPng(path); }), StartsWith(path.string() + ": ")) << length;
  }
  const auto path = dir.write("cut.png", whole.substr(0, whole.size() - 1));
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readPng(path); }),
            path.string() + ": cannot be read as PNG: the file ends early");
}

TEST(ReadPng, AnyWrongByteIsAnInputErrorOrAnImage) {
  const TempDir dir;
  const std::string whole = tinyPng(dir);
  size_t errors = 0;
  for (size_t i = 0; i < whole.size(); i++) {
    for (const char wrong : {'\x00', '\x01', '\x7f', '\xff'}) {
      std::string content = whole;
      if (content[i] == wrong) continue;
      content[i] = wrong;
      const auto path = dir.write("wrong.png", content);
      try {
        readPng(path);
      } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::Input);
        EXPECT_THAT(e.what(), StartsWith(path.string() + ": "));
        errors++;
      }
    }
  }
  EXPECT_GT(errors, whole.size());
}

TEST(ReadPng, WhatIsNoFileIsSaidExactly) {
  const TempDir dir;
  const std::string missing = (dir / "missing.png").string();
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readPng(missing); }), missing + ": no such file");
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readPng(dir.path()); }),
            dir.path().string() + ": is a directory, expected a file");
  const std::string empty = dir.write("empty.png", "").string();
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readPng(empty); }), empty + ": is empty");
}

TEST(ReadPng, FileOfAnotherFormatIsNamedByItsFirstBytes) {
  const TempDir dir;
  const std::string text = dir.write("a.png", "# vtk DataFile Version 2.0").string();
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readPng(text); }),
            text + ": is not a PNG image: begins with 23 20 76 74 6b 20 44 61, expected 89 50 4e 47 0d 0a 1a 0a");
}

// The file with another width, its checksum corrected.
std::string withWidth(std::string content, std::uint32_t width) {
  constexpr size_t kType = 12;  // IHDR's name, then width, height and 5 bytes more, then the checksum of all
  const auto put = [&](size_t at, std::uint32_t value) {
    for (size_t i = 0; i < 4; i++) content[at + i] = static_cast<char>(value >> (24 - 8 * i));
  };
  put(kType + 4, width);
  const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(content.data()) + kType, 17);
  put(kType + 17, static_cast<std::uint32_t>(sum));
  return content;
}

TEST(ReadPng, AbsurdSizesAreRefusedWithTheirNumbers) {
  const TempDir dir;
  const std::string whole = tinyPng(dir);
  const auto path = dir.write("a.png", withWidth(whole, 2000000000));
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readPng(path); }),
            path.string() + ": is 2000000000 x 2 pixels, expected 1 to 65536 a side and at most 268435456 in all");
  const auto none = dir.write("b.png", withWidth(whole, 0));
  EXPECT_THAT(errorOf(ErrorCode::Input, [&] { readPng(none); }),
              StartsWith(none.string() + ": cannot be read as PNG: "));
}

TEST(ReadPng, FewerPixelsThanClaimedIsAnInputError) {
  const TempDir dir;
  const auto path = dir.write("a.png", withWidth(tinyPng(dir), 4));
  EXPECT_THAT(errorOf(ErrorCode::Input, [&] { readPng(path); }),
              StartsWith(path.string() + ": cannot be read as PNG: "));
}

// --- Writing ---------------------------------------------------------------------------------------------------------

TEST(WritePng, PlaceThatCannotBeWrittenIsAnOutputError) {
  const TempDir dir;
  const Image image = smoothImage(2, 2);
  const std::string missing = (dir / "none/a.png").string();
  EXPECT_EQ(errorOf(ErrorCode::Output, [&] { writePng(image, missing, glm::vec3(0.0f)); }),
            missing + ": no such folder " + (dir / "none").string());
  EXPECT_EQ(errorOf(ErrorCode::Output, [&] { writePng(image, dir.path(), glm::vec3(0.0f)); }),
            dir.path().string() + ": is a directory, expected a file name");
  // A folder in which nobody, not even the superuser, may create files.
  EXPECT_THAT(errorOf(ErrorCode::Output, [&] { writePng(image, "/proc/a.png", glm::vec3(0.0f)); }),
              StartsWith("/proc/a.png: cannot be written: "));
  EXPECT_EQ(dir.entries(), 0u);
}

TEST(WritePng, FullDiskLeavesTheOldFileAndNothingElse) {
  const TempDir dir;
  const auto path = dir.write("a.png", "old");
  // Small: the system tells when the file is closed. Large: in the middle of the pixels.
  for (const std::uint32_t side : {4u, 128u}) {
    const Image image = withNoise(smoothImage(side, side), 0.5f, 1);
    const std::string error = errorOf(ErrorCode::Output, [&] {
      const FullDisk full(60);
      writePng(image, path, glm::vec3(0.0f));
    });
    EXPECT_EQ(error, path.string() + ": cannot be written: File too large") << side;
    EXPECT_EQ(readTextFile(path), "old");
    EXPECT_EQ(dir.entries(), 1u);
  }
}

TEST(WritePng, EmptyImageIsADefectOfTheCaller) {
  const TempDir dir;
  EXPECT_THROW(writePng(Image(), dir / "a.png", glm::vec3(0.0f)), CheckFailure);
  EXPECT_EQ(dir.entries(), 0u);
}

}  // namespace
}  // namespace tetralux
