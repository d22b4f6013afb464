#include "chart/csv.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"

namespace tetralux::chart {
namespace {

struct Record {
  std::vector<std::string> fields;
  size_t line = 0;          // where it begins, from 1
  bool isComplete = false;  // ended by a line break
};

// Records of a text; the last one may be cut off anywhere, within quotes as well.
std::vector<Record> splitRecords(std::string_view text) {
  std::vector<Record> records;
  size_t line = 1;
  size_t at = 0;
  while (at < text.size()) {
    Record record;
    record.line = line;
    record.fields.emplace_back();
    bool isQuoted = false;
    for (; at < text.size() && !record.isComplete; at++) {
      const char c = text[at];
      if (c == '\n') line++;
      std::string& field = record.fields.back();
      if (isQuoted) {
        const bool isDoubled = c == '"' && at + 1 < text.size() && text[at + 1] == '"';
        if (isDoubled) at++;
        if (c == '"' && !isDoubled)
          isQuoted = false;
        else
          field += c;
      } else if (c == '"') {
        isQuoted = true;
      } else if (c == ',') {
        record.fields.emplace_back();
      } else if (c == '\n') {
        record.isComplete = true;
      } else if (c != '\r') {
        field += c;
      }
    }
    records.push_back(std::move(record));
  }
  return records;
}

std::vector<std::string> fieldsOf(const CsvTable& table, const CsvRow& row) {
  std::vector<std::string> fields;
  for (const std::string& column : table.columns) {
    const auto found = row.find(column);
    fields.push_back(found == row.end() ? "" : found->second);
  }
  return fields;
}

}  // namespace

std::string csvLine(const std::vector<std::string>& fields) {
  std::string line;
  for (size_t i = 0; i < fields.size(); i++) {
    if (i > 0) line += ',';
    if (fields[i].find_first_of(",\"\r\n") == std::string::npos) {
      line += fields[i];
      continue;
    }
    line += '"';
    for (const char c : fields[i]) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + '\n';
}

std::string csvText(const CsvTable& table) {
  std::string text = csvLine(table.columns);
  for (const CsvRow& row : table.rows) text += csvLine(fieldsOf(table, row));
  return text;
}

CsvTable parseCsv(std::string_view text, const std::string& place) {
  const std::vector<Record> records = splitRecords(text);
  CsvTable table;
  if (records.empty() || !records[0].isComplete) return table;
  table.columns = records[0].fields;
  for (auto column = table.columns.begin(); column != table.columns.end(); ++column) {
    if (std::find(table.columns.begin(), column, *column) != column)
      fail(ErrorCode::Input, "{}: line 1: column '{}' named twice, expected once", place, *column);
  }
  for (size_t i = 1; i < records.size(); i++) {
    const Record& record = records[i];
    if (!record.isComplete || record.fields.size() != table.columns.size()) {
      if (i + 1 == records.size()) break;
      fail(ErrorCode::Input, "{}: line {}: {} fields, expected {}", place, record.line, record.fields.size(),
           table.columns.size());
    }
    CsvRow row;
    for (size_t c = 0; c < table.columns.size(); c++) row[table.columns[c]] = record.fields[c];
    table.rows.push_back(std::move(row));
  }
  return table;
}

CsvFile::CsvFile(std::filesystem::path path, CsvTable table) : path_(std::move(path)), table_(std::move(table)) {
  writeFile(path_, csvText(table_));
  file_.open(path_, std::ios::binary | std::ios::app);
  if (!file_) fail(ErrorCode::Output, "{}: cannot be opened for writing", path_.string());
}

void CsvFile::append(const CsvRow& row) {
  file_ << csvLine(fieldsOf(table_, row)) << std::flush;
  if (!file_) fail(ErrorCode::Output, "{}: cannot be written", path_.string());
  table_.rows.push_back(row);
}

}  // namespace tetralux::chart
