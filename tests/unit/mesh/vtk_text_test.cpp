#include "mesh/vtk_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "unit/mesh/mesh_io_fixtures.h"

namespace tetralux {
namespace {

using test::errorOf;

template <typename T>
T number(std::string_view word) {
  T value{};
  EXPECT_TRUE(parseNumber(word, value)) << word;
  return value;
}

template <typename T>
bool isNumber(std::string_view word) {
  T value{};
  return parseNumber(word, value);
}

TEST(VtkText, NumbersInEveryNotationThatWritersUse) {
  EXPECT_EQ(number<float>("0.1"), 0.1f);
  EXPECT_EQ(number<double>("-1.5e-3"), -1.5e-3);
  EXPECT_EQ(number<double>("+2"), 2.0);
  EXPECT_EQ(number<double>("1E5"), 1e5);
  EXPECT_EQ(number<double>(".5"), 0.5);
  EXPECT_EQ(number<double>("5."), 5.0);
  EXPECT_EQ(number<std::int64_t>("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(number<std::uint64_t>("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(number<std::int8_t>("-128"), -128);
  EXPECT_EQ(number<std::uint8_t>("255"), 255);
}

TEST(VtkText, NonFiniteWordsAreNumbersOfFloatingPointTypesOnly) {
  for (const char* word : {"nan", "NaN", "-nan", "NAN"}) EXPECT_TRUE(std::isnan(number<float>(word))) << word;
  for (const char* word : {"inf", "Inf", "+inf", "INFINITY"}) EXPECT_EQ(number<double>(word), INFINITY) << word;
  EXPECT_EQ(number<double>("-inf"), -INFINITY);
  EXPECT_FALSE(isNumber<std::int32_t>("nan"));
}

TEST(VtkText, ExtremesAreExactAndWhatIsTooSmallForFloatBecomesZeroOrDenormal) {
  EXPECT_EQ(number<float>("3.40282347e+38"), std::numeric_limits<float>::max());
  EXPECT_EQ(number<float>("1.4e-45"), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(number<double>("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(number<float>("1e-60"), 0.0f);
  EXPECT_FALSE(isNumber<float>("1e39"));
  EXPECT_FALSE(isNumber<double>("1e309"));
}

TEST(VtkText, WhatIsNotWhollyANumberIsNone) {
  for (const char* word : {"", "x", "1x", "1.5.2", "+-1", "--1", "0x10", "1,5", "1e", "+"})
    EXPECT_FALSE(isNumber<double>(word)) << word;
  for (const char* word : {"1.5", "1e3", "256", "-1"}) EXPECT_FALSE(isNumber<std::uint8_t>(word)) << word;
}

TEST(VtkText, ScannerTakesWordsAndLines) {
  TextScanner scanner(" one\ttwo\r\nrest of line\r\n\nlast");
  EXPECT_EQ(scanner.word(), "one");
  EXPECT_EQ(scanner.peekWord(), "two");
  EXPECT_EQ(scanner.word(), "two");
  EXPECT_EQ(scanner.line(), "");
  EXPECT_EQ(scanner.lineNumber(), 2u);
  EXPECT_EQ(scanner.line(), "rest of line");
  EXPECT_EQ(scanner.line(), "");
  EXPECT_EQ(scanner.line(), "last");
  EXPECT_TRUE(scanner.atEnd());
  EXPECT_EQ(scanner.word(), "");
  EXPECT_EQ(scanner.line(), "");
}

TEST(VtkText, ReadNumbersSaysWhatIsWrong) {
  ArrayValues values = std::vector<std::uint16_t>();
  const auto read = [&](std::string_view text, size_t count) {
    TextScanner scanner(text);
    readNumbers(scanner, count, "f.vtu: a", values);
  };
  read(" 1 2 65535 ", 3);
  EXPECT_EQ(std::get<std::vector<std::uint16_t>>(values), (std::vector<std::uint16_t>{1, 2, 65535}));
  EXPECT_EQ(errorOf([&] { read("1 2     ", 3); }), "f.vtu: a: ends after 2 values, expected 3");
  EXPECT_EQ(errorOf([&] { read("1 65536 3", 3); }), "f.vtu: a: value 1 is '65536', expected a number of type UInt16");
  EXPECT_EQ(errorOf([&] { read("1 2", size_t{1} << 60); }),
            "f.vtu: a: 3 characters are left, expected 1152921504606846976 values");
}

TEST(VtkText, AnExcerptIsShortAndPrintable) {
  EXPECT_EQ(oneLine("a\x1b\n\xc3\xa4\x7f"), "a  \xc3\xa4 ");
  EXPECT_EQ(excerpt("a\x01\x80z"), "a..z");
  EXPECT_EQ(excerpt(std::string(50, 'x')), std::string(40, 'x') + "...");
}

}  // namespace
}  // namespace tetralux
