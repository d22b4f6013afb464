// The folder of large meshes, scenes and exact images, which need not be there.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

namespace tetralux::test {

inline std::filesystem::path sharedPath(const std::filesystem::path& relative) {
  return std::filesystem::path(TETRALUX_SHARED_DIR) / relative;
}

}  // namespace tetralux::test

// Ends the test, visibly skipped, where the file is missing.
#define REQUIRE_SHARED(relative)                                        \
  if (!std::filesystem::exists(::tetralux::test::sharedPath(relative))) \
  GTEST_SKIP() << "needs " << ::tetralux::test::sharedPath(relative)
