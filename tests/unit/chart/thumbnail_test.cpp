#include "chart/thumbnail.h"

#include <gtest/gtest.h>

namespace tetralux::chart {
namespace {

TEST(Thumbnail, KeepsASmallPicture) { EXPECT_EQ(thumbnail(Image(4, 3), 4, Shrink::Mean).width, 4u); }

TEST(Thumbnail, MeanIsTheMeanOfEveryBlock) {
  Image image(5, 2);
  for (std::uint32_t x = 0; x < 5; x++) image.at(x, 0) = image.at(x, 1) = glm::vec4(static_cast<float>(x));
  const Image small = thumbnail(image, 3, Shrink::Mean);
  ASSERT_EQ(small.width, 3u);
  ASSERT_EQ(small.height, 1u);
  EXPECT_EQ(small.at(0, 0).x, 0.5f);
  EXPECT_EQ(small.at(1, 0).x, 2.5f);
  EXPECT_EQ(small.at(2, 0).x, 4.0f);  // half a block
}

TEST(Thumbnail, LightestStillShowsOnePixel) {
  Image image(64, 64);
  image.at(37, 21) = {1.0f, 0.5f, 0.0f, 1.0f};
  EXPECT_EQ(thumbnail(image, 8, Shrink::Lightest).at(4, 2), image.at(37, 21));
}

}  // namespace
}  // namespace tetralux::chart
