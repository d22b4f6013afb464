#include "chart/html_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <span>

#include "chart/svg_text.h"

namespace tetralux::chart {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string uriOf(const std::string& text) {
  return dataUri("text/plain", std::as_bytes(std::span(text.data(), text.size())));
}

// The examples of RFC 4648, section 10.
TEST(DataUri, IsBase64) {
  EXPECT_EQ(uriOf(""), "data:text/plain;base64,");
  EXPECT_EQ(uriOf("f"), "data:text/plain;base64,Zg==");
  EXPECT_EQ(uriOf("fo"), "data:text/plain;base64,Zm8=");
  EXPECT_EQ(uriOf("foobar"), "data:text/plain;base64,Zm9vYmFy");
  EXPECT_EQ(uriOf("\xff\xfe\xfd"), "data:text/plain;base64,//79");
}

TEST(HtmlReport, EscapesTextAndNeedsNothingFromElsewhere) {
  HtmlReport report("a < b");
  report.paragraph("x & y");
  report.table({{"<th>", "n"}, 1, {{"row", "1"}, {"best", "2"}}, {false, true}});
  report.pictures({{"one", "data:image/png;base64,AAAA", "", "note", true}});
  const std::string html = std::move(report).finish();
  EXPECT_THAT(html, HasSubstr("a &lt; b"));
  EXPECT_THAT(html, HasSubstr("x &amp; y"));
  EXPECT_THAT(html, HasSubstr("&lt;th&gt;"));
  EXPECT_THAT(html, HasSubstr("<tr class=\"s\"><td class=\"t\">best</td><td>2</td></tr>"));
  EXPECT_THAT(html, Not(HasSubstr("http")));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_TRUE(html.ends_with("</html>\n"));
}

}  // namespace
}  // namespace tetralux::chart
