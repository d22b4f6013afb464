#include "chart/csv.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "support/expect_error.h"
#include "support/temp_dir.h"

namespace tetralux::chart {
namespace {

using test::errorOf;

const CsvTable& awkwardTable() {
  static const CsvTable table = {{"a", "b, c", "d"},
                                 {{{"a", "1"}, {"b, c", "two, three"}, {"d", ""}},
                                  {{"a", "say \"so\""}, {"b, c", "line\nbreak"}, {"d", "\"\""}},
                                  {{"a", ""}, {"b, c", ""}, {"d", "\xc3\xa9,"}}}};
  return table;
}

TEST(Csv, WhatIsWrittenIsRead) {
  const CsvTable read = parseCsv(csvText(awkwardTable()), "t");
  EXPECT_EQ(read.columns, awkwardTable().columns);
  EXPECT_EQ(read.rows, awkwardTable().rows);
}

TEST(Csv, AColumnThatARowLacksIsEmpty) {
  const CsvTable read = parseCsv(csvText({{"a", "b"}, {{{"b", "2"}}}}), "t");
  EXPECT_EQ(read.rows.at(0).at("a"), "");
}

TEST(Csv, WhereverAWriterWasInterruptedOnlyItsLineIsLost) {
  const std::string text = csvText(awkwardTable());
  size_t mostRows = 0;
  for (size_t length = 0; length < text.size(); length++) {
    const CsvTable read = parseCsv(text.substr(0, length), "t");
    EXPECT_GE(read.rows.size(), mostRows) << length;
    EXPECT_LT(read.rows.size(), awkwardTable().rows.size()) << length;
    for (size_t i = 0; i < read.rows.size(); i++) EXPECT_EQ(read.rows[i], awkwardTable().rows[i]) << length;
    mostRows = read.rows.size();
  }
  EXPECT_EQ(mostRows, awkwardTable().rows.size() - 1);
}

TEST(Csv, DamageElsewhereIsNamed) {
  EXPECT_EQ(errorOf(ErrorCode::Input, [] { parseCsv("a,b\n1\n1,2\n", "f.csv"); }),
            "f.csv: line 2: 1 fields, expected 2");
  EXPECT_EQ(errorOf(ErrorCode::Input, [] { parseCsv("a,a\n", "f.csv"); }),
            "f.csv: line 1: column 'a' named twice, expected once");
}

TEST(CsvFile, RowsAreOnDiskAsSoonAsTheyAreAppended) {
  const test::TempDir dir;
  CsvFile file(dir / "t.csv", {{"a"}, {{{"a", "0"}}}});
  EXPECT_EQ(readTextFile(dir / "t.csv"), "a\n0\n");
  file.append({{"a", "1"}});
  EXPECT_EQ(readTextFile(dir / "t.csv"), "a\n0\n1\n");
  EXPECT_EQ(file.table().rows.size(), 2u);
}

}  // namespace
}  // namespace tetralux::chart
