#include "mesh/vtk_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <type_traits>

#include "base/check.h"
#include "base/error.h"

namespace tetralux {
namespace {

bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// Beginning and end of the word at or after `position`.
std::pair<size_t, size_t> findWord(std::string_view text, size_t position) {
  while (position < text.size() && isSpace(text[position])) position++;
  size_t end = position;
  while (end < text.size() && !isSpace(text[end])) end++;
  return {position, end};
}

}  // namespace

std::string_view TextScanner::word() {
  const auto [begin, end] = findWord(text_, position_);
  position_ = end;
  return text_.substr(begin, end - begin);
}

std::string_view TextScanner::peekWord() const {
  const auto [begin, end] = findWord(text_, position_);
  return text_.substr(begin, end - begin);
}

std::string_view TextScanner::line() {
  const size_t end = std::min(text_.find('\n', position_), text_.size());
  std::string_view line = text_.substr(position_, end - position_);
  position_ = std::min(end + 1, text_.size());
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view TextScanner::bytes(size_t count) {
  CHECK_LE(count, remaining());
  const std::string_view taken = text_.substr(position_, count);
  position_ += count;
  return taken;
}

size_t TextScanner::lineNumber() const {
  const std::string_view before = text_.substr(0, position_);
  return 1 + static_cast<size_t>(std::count(before.begin(), before.end(), '\n'));
}

template <typename T>
bool parseNumber(std::string_view word, T& value) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return false;
  }
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc()) return stop == end;
  if constexpr (std::is_same_v<T, float>) {
    double wide = 0.0;
    if (error == std::errc::result_out_of_range && parseNumber(word, wide) && std::abs(wide) < 1.0) {
      value = static_cast<float>(wide);
      return true;
    }
  }
  return false;
}

template bool parseNumber(std::string_view, std::int8_t&);
template bool parseNumber(std::string_view, std::uint8_t&);
template bool parseNumber(std::string_view, std::int16_t&);
template bool parseNumber(std::string_view, std::uint16_t&);
template bool parseNumber(std::string_view, std::int32_t&);
template bool parseNumber(std::string_view, std::uint32_t&);
template bool parseNumber(std::string_view, std::int64_t&);
template bool parseNumber(std::string_view, std::uint64_t&);
template bool parseNumber(std::string_view, float&);
template bool parseNumber(std::string_view, double&);

void readNumbers(TextScanner& scanner, size_t count, std::string_view place, ArrayValues& values) {
  // A number takes two characters at least, but for the last: no memory for counts that the text cannot hold.
  if (count > scanner.remaining() / 2 + 1)
    fail(ErrorCode::Input, "{}: {} characters are left, expected {} values", place, scanner.remaining(), count);
  std::visit(
      [&](auto& v) {
        v.resize(count);
        for (size_t i = 0; i < count; i++) {
          const std::string_view word = scanner.word();
          if (word.empty()) fail(ErrorCode::Input, "{}: ends after {} values, expected {}", place, i, count);
          if (!parseNumber(word, v[i]))
            fail(ErrorCode::Input, "{}: value {} is '{}', expected a number of type {}", place, i, excerpt(word),
                 DataArray{{}, 1, ArrayValues(std::decay_t<decltype(v)>())}.typeName());
        }
      },
      values);
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string oneLine(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return result;
}

std::string excerpt(std::string_view text) {
  constexpr size_t kLongest = 40;
  std::string result(text.substr(0, kLongest));
  for (char& c : result) {
    if (c < 0x20 || c > 0x7e) c = '.';
  }
  if (text.size() > kLongest) result += "...";
  return result;
}

}  // namespace tetralux
