#include "base/xml_text.h"

#include <gtest/gtest.h>

namespace tetralux {
namespace {

TEST(EscapedXml, KeepsTextAndItsMarkupApart) {
  EXPECT_EQ(escapedXml(""), "");
  EXPECT_EQ(escapedXml("plain 1/510 \xc3\xa9"), "plain 1/510 \xc3\xa9");
  EXPECT_EQ(escapedXml("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
  EXPECT_EQ(escapedXml("&amp;"), "&amp;amp;");
}

TEST(EscapedXml, LeavesNoControlCharacter) {
  EXPECT_EQ(escapedXml("a\tb\nc\rd"), "a&#9;b&#10;c&#13;d");
  EXPECT_EQ(escapedXml(std::string_view("\0\x01\x1f", 3)), "???");
}

}  // namespace
}  // namespace tetralux
