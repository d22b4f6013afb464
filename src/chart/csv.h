// Tables as text, comma-separated (RFC 4180), that survive an interrupted writer.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tetralux::chart {

// Values by column; a column that a row lacks is empty.
using CsvRow = std::map<std::string, std::string>;

struct CsvTable {
  std::vector<std::string> columns;
  std::vector<CsvRow> rows;
};

// One line with its line break; fields with a comma, a quote or a line break are quoted.
std::string csvLine(const std::vector<std::string>& fields);

// Header and rows.
std::string csvText(const CsvTable& table);

// Reads a table. A last line without its line break, or with a number of fields that is not the header's, is what an
// interrupted writer left and is dropped. Throws Error(Input) beginning with `place` for such a line anywhere else, for
// a quote that does not close before the last line, and for a header that names a column twice.
CsvTable parseCsv(std::string_view text, const std::string& place);

// A table on disk that grows by whole lines.
class CsvFile {
 public:
  // Writes the table, complete or not at all, in place of what is there, and keeps the file open. Throws Error(Output).
  CsvFile(std::filesystem::path path, CsvTable table);

  const CsvTable& table() const { return table_; }

  // Adds a row and hands it to the system before it returns. Throws Error(Output).
  void append(const CsvRow& row);

 private:
  std::filesystem::path path_;
  CsvTable table_;
  std::ofstream file_;
};

}  // namespace tetralux::chart
