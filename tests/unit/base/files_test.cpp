#include "base/files.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/expect_error.h"
#include "support/temp_dir.h"

namespace tetralux {
namespace {

using test::errorOf;
using test::TempDir;

TEST(Files, ReadGivesTheWholeContent) {
  const TempDir dir;
  EXPECT_EQ(readTextFile(dir.write("a", std::string("x\0y", 3))), std::string("x\0y", 3));
  EXPECT_EQ(readFile(dir / "a").size(), 3u);
}

TEST(Files, WhatCannotBeReadIsNamed) {
  const TempDir dir;
  const std::string base = dir.path().string();
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readFile(dir / "none"); }), base + "/none: no such file");
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readFile(dir.path()); }), base + ": is a directory, expected a file");
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readFile(dir.write("empty", "")); }), base + "/empty: is empty");
}

TEST(PendingFile, AppearsOnlyWithCommit) {
  const TempDir dir;
  {
    const PendingFile pending(dir / "out.exr");
    EXPECT_EQ(pending.temporaryPath().extension(), ".exr");
    EXPECT_FALSE(std::filesystem::exists(dir / "out.exr"));
  }
  EXPECT_EQ(dir.entries(), 0u);
  {
    PendingFile pending(dir / "out.exr");
    pending.commit();
  }
  EXPECT_TRUE(std::filesystem::exists(dir / "out.exr"));
  EXPECT_EQ(dir.entries(), 1u);
}

TEST(PendingFile, AnExistingFileIsUntouchedWithoutCommit) {
  const TempDir dir;
  dir.write("out", "old");
  { const PendingFile pending(dir / "out"); }
  EXPECT_EQ(readTextFile(dir / "out"), "old");
  EXPECT_EQ(dir.entries(), 1u);
}

TEST(PendingFile, PlacesThatCannotBeWrittenAreNamed) {
  const TempDir dir;
  const std::string base = dir.path().string();
  EXPECT_EQ(errorOf(ErrorCode::Output, [&] { PendingFile pending(dir / "no/out"); }),
            base + "/no/out: no such folder " + base + "/no");
  EXPECT_EQ(errorOf(ErrorCode::Output, [&] { PendingFile pending(dir.path()); }),
            base + ": is a directory, expected a file name");
  EXPECT_EQ(errorOf(ErrorCode::Output, [&] { PendingFile pending(""); }), "'': not a file name");
}

TEST(Files, WriteReplacesTheContent) {
  const TempDir dir;
  dir.write("out", "old and longer");
  writeFile(dir / "out", "new");
  EXPECT_EQ(readTextFile(dir / "out"), "new");
}

}  // namespace
}  // namespace tetralux
