#include "base/error.h"

#include <gtest/gtest.h>

#include "base/check.h"

namespace tetralux {
namespace {

TEST(Error, IsOneLineWhateverTheNamesInIt) {
  const Error error(ErrorCode::Input, "a\nb\tc\x7f.");
  EXPECT_STREQ(error.what(), "a b c .");
  EXPECT_EQ(error.code(), ErrorCode::Input);
}

TEST(Error, IsNotEndless) {
  EXPECT_LT(std::string(Error(ErrorCode::Input, std::string(100000, 'x')).what()).size(), 500u);
}

TEST(Error, CodesAreTheDocumentedExitStatuses) {
  EXPECT_EQ(static_cast<int>(ErrorCode::Limit), 1);
  EXPECT_EQ(static_cast<int>(ErrorCode::Usage), 2);
  EXPECT_EQ(static_cast<int>(ErrorCode::Input), 3);
  EXPECT_EQ(static_cast<int>(ErrorCode::Device), 4);
  EXPECT_EQ(static_cast<int>(ErrorCode::Output), 5);
}

TEST(Check, FailureShowsBothValues) {
  try {
    const int three = 3;
    CHECK_EQ(three, 4);
    FAIL();
  } catch (const CheckFailure& e) {
    EXPECT_NE(std::string(e.what()).find("three == 4: 3 against 4"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace tetralux
