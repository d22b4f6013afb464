#include "mesh/base64.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "unit/mesh/vtu_builder.h"

namespace tetralux {
namespace {

using test::encodeBase64;

// Everything that is left, taken `step` bytes at a time.
std::string decodeAll(Base64Reader& reader, size_t step) {
  std::string bytes;
  std::vector<std::byte> part(step);
  for (;;) {
    const size_t available = reader.available();
    const size_t got = reader.read(part.data(), step);
    EXPECT_LE(got, available);
    bytes.append(reinterpret_cast<const char*>(part.data()), got);
    if (got < step) return bytes;
  }
}

std::string decodeAll(std::string_view text, size_t step = 7) {
  Base64Reader reader(text);
  return decodeAll(reader, step);
}

TEST(Base64, DecodesTheExamplesOfRfc4648) {
  EXPECT_EQ(decodeAll(""), "");
  EXPECT_EQ(decodeAll("Zg=="), "f");
  EXPECT_EQ(decodeAll("Zm8="), "fo");
  EXPECT_EQ(decodeAll("Zm9v"), "foo");
  EXPECT_EQ(decodeAll("Zm9vYg=="), "foob");
  EXPECT_EQ(decodeAll("Zm9vYmE="), "fooba");
  EXPECT_EQ(decodeAll("Zm9vYmFy"), "foobar");
}

TEST(Base64, EveryLengthComesBackInPartsOfAnySize) {
  std::mt19937 random(1);
  for (size_t size = 0; size < 40; size++) {
    std::string bytes(size, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    for (const size_t step : {1u, 2u, 3u, 4u, 5u, 64u}) EXPECT_EQ(decodeAll(encodeBase64(bytes), step), bytes);
  }
}

TEST(Base64, PaddingEndsARunAndTheNextBeginsAfterIt) {
  EXPECT_EQ(decodeAll("Zg==Zm8=Zm9vZg=="), "ffofoof");
  EXPECT_EQ(decodeAll("Zg==Zm8=Zm9vZg==", 1), "ffofoof");
}

TEST(Base64, WhiteSpaceMayStandAnywhere) { EXPECT_EQ(decodeAll(" \n Z\tm9\r\nv Y g = = \n"), "foob"); }

TEST(Base64, ATextWithoutItsPaddingIsComplete) { EXPECT_EQ(decodeAll("Zm9vYg"), "foob"); }

TEST(Base64, AForeignCharacterIsPointedAt) {
  Base64Reader reader("Zm9v\n*mFy");
  EXPECT_EQ(decodeAll(reader, 3), "foo");
  EXPECT_FALSE(reader.atEnd());
  EXPECT_EQ(reader.position(), 5u);
}

TEST(Base64, PaddingOrDigitsInTheWrongPlaceAreForeign) {
  for (const char* text : {"=", "Z===", "Zg=v", "Zm9v="}) {
    Base64Reader reader(text);
    decodeAll(reader, 3);
    EXPECT_FALSE(reader.atEnd()) << text;
  }
}

TEST(Base64, AtTheEndTheTextIsUsedUp) {
  Base64Reader reader("Zm9v \n");
  EXPECT_EQ(decodeAll(reader, 5), "foo");
  EXPECT_TRUE(reader.atEnd());
}

}  // namespace
}  // namespace tetralux
