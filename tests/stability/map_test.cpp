// Outcomes as a file and as a picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "stability/color_scale.h"
#include "stability/failure_map.h"
#include "stability/outcome_table.h"
#include "support/expect_error.h"
#include "support/temp_dir.h"

namespace tetralux::stability {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<Outcome> someOutcomes() {
  Outcome good{"a <region>", "default"};
  good.rmse = 0.1 / 3.0 * 1e-5;
  good.largest = 1e-5;
  good.worstCase = "one, two";
  Outcome none{"a <region>", "projection march"};
  none.applies = false;
  Outcome bad{"another", "default"};
  bad.rmse = 0.2;
  bad.largest = 0.97;
  Outcome wrong{"another", "projection march"};
  wrong.largest = 1.0;
  wrong.nonFinite = 3;
  return {good, none, bad, wrong};
}

TEST(OutcomeTable, IsReadBackAsItWas) {
  const test::TempDir dir;
  const auto read = readOutcomeCsv(dir.write("t.csv", outcomeCsv(someOutcomes())));
  ASSERT_EQ(read.size(), 4u);
  for (size_t i = 0; i < 4; i++) {
    const Outcome expected = someOutcomes()[i];
    EXPECT_EQ(read[i].region, expected.region);
    EXPECT_EQ(read[i].method, expected.method);
    EXPECT_EQ(read[i].applies, expected.applies);
    EXPECT_EQ(read[i].rmse, expected.rmse);
    EXPECT_EQ(read[i].largest, expected.largest);
    EXPECT_EQ(read[i].nonFinite, expected.nonFinite);
  }
  EXPECT_EQ(read[0].worstCase, "one; two");
}

TEST(OutcomeTable, NamesTheLineThatIsWrong) {
  const test::TempDir dir;
  const std::string head = "region,method,rmse,largest,non_finite,worst_case\n";
  const auto error = [&](const std::string& text) {
    return test::errorOf(ErrorCode::Input, [&] { readOutcomeCsv(dir.write("t.csv", text)); });
  };
  EXPECT_THAT(error("region\n"), HasSubstr("line 1: found 'region', expected"));
  EXPECT_THAT(error(head + "a,b,1,2,0,\na,b,1\n"), HasSubstr("line 3: found 3 values, expected 6"));
  EXPECT_THAT(error(head + "a,b,1,x,0,\n"), HasSubstr("line 2: found 'x', expected a number"));
}

TEST(FailureMap, ShowsEveryOutcomeOnce) {
  const std::string svg = failureMapSvg(someOutcomes(), "a & b");
  EXPECT_THAT(svg, HasSubstr("a &amp; b"));
  EXPECT_THAT(svg, HasSubstr("a &lt;region&gt;, default: largest 1e-05"));
  EXPECT_THAT(svg, HasSubstr(">1e-5</text>"));
  EXPECT_THAT(svg, HasSubstr("projection march: does not apply"));
  EXPECT_THAT(svg, HasSubstr(">NaN</text>"));
  EXPECT_THAT(svg, HasSubstr(">1</text>"));  // 0.97, to one digit
  EXPECT_THAT(svg, Not(HasSubstr("<region>")));
}

TEST(FailureMap, PageHoldsThePictureAndRefersToNothing) {
  const std::string html = failureMapHtml(someOutcomes(), "device");
  EXPECT_THAT(html, HasSubstr(failureMapSvg(someOutcomes(), "device")));
  EXPECT_THAT(html, Not(HasSubstr("src=")));
  EXPECT_THAT(html, Not(HasSubstr("href=")));
}

// Lightness falls with every step of the error: the order shows without colour.
TEST(ColorScale, IsOrderedByLightness) {
  double last = 1e9;
  for (double exponent = -7.0; exponent <= 0.0; exponent += 0.125) {
    const Rgb8 c = errorColor(std::pow(10.0, exponent));
    const double lightness =
        0.2126 * std::pow(c.r / 255.0, 2.2) + 0.7152 * std::pow(c.g / 255.0, 2.2) + 0.0722 * std::pow(c.b / 255.0, 2.2);
    EXPECT_LT(lightness, last) << exponent;
    last = lightness;
  }
  EXPECT_EQ(errorColor(0.0).r, errorColor(1e-9).r);
}

}  // namespace
}  // namespace tetralux::stability
