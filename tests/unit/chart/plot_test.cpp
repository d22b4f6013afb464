#include "chart/plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "chart/bars.h"

namespace tetralux::chart {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Plot samplePlot() {
  Plot plot;
  plot.title = "a < b & \"c\"";
  plot.x = {"ms", Axis::logarithmic({10.0, 100.0})};
  plot.y = {"error", Axis::logarithmic({1e-6, 1e-2})};
  plot.marks = {
      {10.0, 1e-2, {}, "quick", "", true}, {100.0, 1e-6, {}, "exact", "", true}, {100.0, 1e-3, {}, "bad", "", false}};
  plot.front = {{10.0, 1e-2}, {100.0, 1e-6}};
  return plot;
}

size_t countOf(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) count++;
  return count;
}

// Numbers that stand in drawing commands and positions.
void expectInside(const std::string& svg, double width, double height) {
  const std::regex position(R"re( (x|y)="([-0-9.]+)")re");
  for (std::sregex_iterator it(svg.begin(), svg.end(), position), end; it != end; ++it) {
    const double value = std::stod((*it)[2]);
    EXPECT_GE(value, 0.0) << it->str();
    EXPECT_LE(value, (*it)[1] == "x" ? width : height) << it->str();
  }
}

TEST(PlotSvg, HoldsEveryMarkItsLabelAndTheFront) {
  const std::string svg = plotSvg(samplePlot());
  EXPECT_EQ(countOf(svg, "class=\"mark"), 3u);
  EXPECT_EQ(countOf(svg, "class=\"front\""), 1u);
  for (const char* label : {">quick<", ">exact<", ">bad<"}) EXPECT_THAT(svg, HasSubstr(label));
  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; &quot;c&quot;"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  expectInside(svg, 960, 560);
}

TEST(PlotSvg, AnErrorOfZeroHasALineOfItsOwn) {
  Plot plot = samplePlot();
  EXPECT_THAT(plotSvg(plot), Not(HasSubstr(">0<")));
  plot.marks[1].y = 0.0;
  const std::string svg = plotSvg(plot);
  EXPECT_THAT(svg, HasSubstr(">0<"));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  expectInside(svg, 960, 560);
}

TEST(PlotSvg, SameInputSameText) { EXPECT_EQ(plotSvg(samplePlot()), plotSvg(samplePlot())); }

TEST(PlotSvg, NeedsNothingFromElsewhere) {
  std::string svg = plotSvg(samplePlot());
  const std::string nameSpace = "http://www.w3.org/2000/svg";
  svg.erase(svg.find(nameSpace), nameSpace.size());
  EXPECT_THAT(svg, Not(HasSubstr("http")));
}

// What is white on white must be dark on dark.
TEST(PlotSvg, EveryPaperColourHasItsDarkOne) {
  const std::string svg = plotSvg(samplePlot());
  const size_t dark = svg.find("@media");
  ASSERT_NE(dark, std::string::npos);
  const std::regex paper(R"((\.[a-z]+)\{[^}]*#fff\b)");
  size_t count = 0;
  for (std::sregex_iterator it(svg.begin(), svg.begin() + static_cast<std::ptrdiff_t>(dark), paper), end; it != end;
       ++it, count++)
    EXPECT_NE(svg.find((*it)[1].str(), dark), std::string::npos) << (*it)[1];
  EXPECT_EQ(count, 3u);  // ground, labels, marks
}

TEST(PlotSvg, LinesHaveTheirNamesOrARightScale) {
  Plot plot = samplePlot();
  plot.marks.clear();
  plot.front.clear();
  plot.lines = {{"first", {0, Shape::Circle}, {{10, 1e-3}, {100, 1e-4}}},
                {"second", {1, Shape::Square}, {{10, 1e-3}, {100, 1e-4}}}};
  EXPECT_EQ(countOf(plotSvg(plot), "class=\"line"), 2u);
  EXPECT_THAT(plotSvg(plot), HasSubstr(">second<"));
  plot.right = RightScale{"per cell", 1e3};
  EXPECT_THAT(plotSvg(plot), HasSubstr("per cell"));
  expectInside(plotSvg(plot), 960, 560);
}

TEST(BarsSvg, SaysHowMuchIsAdded) {
  const std::string svg = barsSvg("t", "cells", "added", {{"a", 100, 133}, {"b", 50, 50}});
  EXPECT_THAT(svg, HasSubstr("+33.0 %"));
  EXPECT_THAT(svg, HasSubstr("+0.0 %"));
}

}  // namespace
}  // namespace tetralux::chart
