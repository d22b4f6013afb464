#include "image/image_io.h"

#include <gtest/gtest.h>

#include "image_fixtures.h"
#include "support/temp_dir.h"

namespace tetralux {
namespace {

using namespace test;

TEST(ExrCompressionNames, EveryNameParsesToItsCompression) {
  for (int i = 0; i <= static_cast<int>(ExrCompression::Dwab); i++) {
    const auto compression = static_cast<ExrCompression>(i);
    EXPECT_EQ(parseExrCompression(exrCompressionName(compression)), compression);
  }
  EXPECT_STREQ(exrCompressionName(ExrCompression::Pxr24), "pxr24");
}

TEST(ExrCompressionNames, UnknownNameListsTheKnownOnes) {
  EXPECT_EQ(errorOf(ErrorCode::Usage, [] { parseExrCompression("ZIP"); }),
            "unknown compression 'ZIP', expected none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab");
}

TEST(ReadImage, ChoosesByExtensionInAnyCase) {
  const TempDir dir;
  const Image image = constantImage(2, 1, {1.0f, 0.0f, 1.0f, 1.0f});
  writeExr(image, dir / "a.EXR");
  writePng(image, dir / "a.Png", glm::vec3(0.0f));
  EXPECT_EQ(largestDifference(readImage(dir / "a.EXR"), image), 0.0);
  EXPECT_EQ(largestDifference(readImage(dir / "a.Png"), image), 0.0);
}

TEST(ReadImage, OtherExtensionIsRefused) {
  EXPECT_EQ(errorOf(ErrorCode::Input, [] { readImage("folder/a.jpg"); }),
            "folder/a.jpg: unknown image format '.jpg', expected .exr or .png");
  EXPECT_EQ(errorOf(ErrorCode::Input, [] { readImage("exr"); }), "exr: unknown image format '', expected .exr or .png");
}

}  // namespace
}  // namespace tetralux
