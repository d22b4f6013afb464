#include "stability/outcome_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "base/error.h"
#include "base/files.h"

namespace tetralux::stability {
namespace {

constexpr std::string_view kHeader = "region,method,rmse,largest,non_finite,worst_case";

// Names within cases may hold commas.
std::string withoutCommas(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  return text;
}

template <typename T>
T numberOf(const std::string& text, const std::filesystem::path& path, size_t line) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    fail(ErrorCode::Input, "{}: line {}: found '{}', expected a number", path.string(), line, text);
  return value;
}

}  // namespace

std::string outcomeCsv(std::span<const Outcome> outcomes) {
  std::string text = fmt::format("{}\n", kHeader);
  for (const Outcome& o : outcomes) {
    if (o.applies)
      text += fmt::format("{},{},{},{},{},{}\n", o.region, o.method, o.rmse, o.largest, o.nonFinite,
                          withoutCommas(o.worstCase));
    else
      text += fmt::format("{},{},,,,\n", o.region, o.method);
  }
  return text;
}

std::vector<Outcome> readOutcomeCsv(const std::filesystem::path& path) {
  std::istringstream file(readTextFile(path));
  std::vector<Outcome> outcomes;
  std::string text;
  for (size_t line = 1; std::getline(file, text); line++) {
    if (line == 1) {
      if (text != kHeader)
        fail(ErrorCode::Input, "{}: line 1: found '{}', expected '{}'", path.string(), text, kHeader);
      continue;
    }
    std::vector<std::string> parts(1);
    for (const char c : text) {
      if (c == ',')
        parts.emplace_back();
      else
        parts.back() += c;
    }
    if (parts.size() != 6)
      fail(ErrorCode::Input, "{}: line {}: found {} values, expected 6", path.string(), line, parts.size());
    Outcome o{parts[0], parts[1]};
    o.applies = !parts[2].empty();
    if (o.applies) {
      o.rmse = numberOf<double>(parts[2], path, line);
      o.largest = numberOf<double>(parts[3], path, line);
      o.nonFinite = numberOf<std::uint64_t>(parts[4], path, line);
      o.worstCase = parts[5];
    }
    outcomes.push_back(std::move(o));
  }
  return outcomes;
}

}  // namespace tetralux::stability
