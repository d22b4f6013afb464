// The text of an expected error.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"

namespace tetralux::test {

// Runs the action and returns what() of the Error that it throws, which must have this code.
template <typename Action>
std::string errorOf(ErrorCode code, const Action& action) {
  try {
    action();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), code) << e.what();
    return e.what();
  }
  return "no error";
}

}  // namespace tetralux::test
