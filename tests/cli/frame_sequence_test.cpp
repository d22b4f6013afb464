#include "cli/frame_sequence.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace tetralux::cli {
namespace {

TEST(FramePattern, PutsTheNumberInItsPlace) {
  EXPECT_EQ(FramePattern("a.exr").name(7), "a.exr");
  EXPECT_EQ(FramePattern("a_%d.exr").name(7), "a_7.exr");
  EXPECT_EQ(FramePattern("a_%04d.exr").name(7), "a_0007.exr");
  EXPECT_EQ(FramePattern("a_%4d.exr").name(7), "a_   7.exr");
  EXPECT_EQ(FramePattern("100%%_%03d.exr").name(12345), "100%_12345.exr");
  EXPECT_FALSE(FramePattern("50%%.png").hasNumber());
}

TEST(FramePattern, OtherConversionsAreBadUsage) {
  for (const char* text : {"%s.exr", "%", "a%n", "%d%d", "%5", "%05.2f", "%99999999999d", "%-4d"})
    EXPECT_NE(test::errorOf(ErrorCode::Usage, [&] { FramePattern pattern(text); }), "no error") << text;
}

}  // namespace
}  // namespace tetralux::cli
