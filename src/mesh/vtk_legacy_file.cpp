#include "mesh/vtk_legacy_file.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <charconv>
#include <cstring>
#include <span>

#include "base/error.h"
#include "base/files.h"
#include "mesh/vtk_types.h"

namespace tetralux {
namespace {

// VTK writes characters of names that would end a word as '%' and two hexadecimal digits.
std::string decoded(std::string_view word) {
  std::string result;
  for (size_t i = 0; i < word.size(); i++) {
    std::uint8_t code = 0;
    if (word[i] == '%' && i + 2 < word.size()) {
      const char* end = word.data() + i + 3;
      if (std::from_chars(end - 2, end, code, 16).ptr == end) {
        result += static_cast<char>(code);
        i += 2;
        continue;
      }
    }
    result += word[i];
  }
  return result;
}

}  // namespace

VtkLegacyFile::VtkLegacyFile(const std::filesystem::path& path)
    : name_(path.string()), file_(readTextFile(path)), scanner_(file_) {
  readHeader();
}

void VtkLegacyFile::readHeader() {
  constexpr std::string_view kMagic = "# vtk DataFile Version ";
  const std::string_view first = scanner_.line();
  if (!first.starts_with(kMagic))
    fail(ErrorCode::Input, "{}: line 1: '{}', expected '{}5.1' or an earlier one", name_, excerpt(first), kMagic);
  const std::string_view version = TextScanner(first.substr(kMagic.size())).word();
  unsigned major = 0;
  std::from_chars(version.data(), version.data() + version.size(), major);
  constexpr unsigned kNewest = 5;
  if (major < 1 || major > kNewest)
    fail(ErrorCode::Input, "{}: line 1: version '{}', expected 1 to {}", name_, excerpt(version), kNewest);
  scanner_.line();  // a title
  const std::string_view format = scanner_.word();
  isBinary_ = lowerCase(format) == "binary";
  if (!isBinary_ && lowerCase(format) != "ascii")
    fail(ErrorCode::Input, "{}: line 3: '{}', expected ASCII or BINARY", name_, excerpt(format));
}

std::string VtkLegacyFile::location() const {
  return isBinary_ ? fmt::format("byte {}", scanner_.position()) : fmt::format("line {}", scanner_.lineNumber());
}

std::string VtkLegacyFile::text(const char* what) {
  const std::string_view word = scanner_.word();
  if (word.empty()) fail(ErrorCode::Input, "{}: {}: the file ends, expected {}", name_, location(), what);
  return decoded(word);
}

size_t VtkLegacyFile::count(const char* what) {
  const std::string_view word = scanner_.word();
  std::uint64_t number = 0;
  if (word.empty()) fail(ErrorCode::Input, "{}: {}: the file ends, expected {}", name_, location(), what);
  if (!parseNumber(word, number))
    fail(ErrorCode::Input, "{}: {}: '{}', expected {}", name_, location(), excerpt(word), what);
  return number;
}

std::string_view VtkLegacyFile::bytes(size_t size, std::string_view place) {
  if (size > scanner_.remaining())
    fail(ErrorCode::Input, "{}: data ends after {} bytes, expected {}", place, scanner_.remaining(), size);
  return scanner_.bytes(size);
}

std::optional<ArrayValues> VtkLegacyFile::values(std::string_view type, size_t tuples, size_t components,
                                                 std::string_view place) {
  const auto count = numberCount(tuples, components);
  if (!count) fail(ErrorCode::Input, "{}: {} tuples of {} components, expected fewer", place, tuples, components);
  std::optional<ArrayValues> values = valuesOfLegacyType(type);
  const std::string lower = lowerCase(type);
  if (values && isBinary_) {
    readBinary(*count, place, *values);
  } else if (values) {
    readNumbers(scanner_, *count, place, *values);
  } else if (lower == "bit") {
    passOverBits(*count, place);
  } else if (lower == "string" || lower == "utf8_string") {
    passOverStrings(*count, place);
  } else {
    fail(ErrorCode::Input, "{}: type '{}', expected char, short, int, long, vtktypeint64, float, double or the like",
         place, excerpt(type));
  }
  if (!values) spdlog::warn("{}: not read: an array of type '{}'", oneLine(place), lower);
  passOverMetadata();
  return values;
}

void VtkLegacyFile::readBinary(size_t count, std::string_view place, ArrayValues& values) {
  if (count == 0) return;  // then there is no line of data either
  scanner_.line();
  const size_t width = numberSize(values);
  const std::string_view data = bytes(count * width, place);
  std::visit(
      [&](auto& v) {
        v.resize(count);
        std::memcpy(v.data(), data.data(), data.size());
        if (!kHostIsBigEndian) swapBytes(v.data(), count, width);
      },
      values);
}

void VtkLegacyFile::passOverBits(size_t count, std::string_view place) {
  if (isBinary_) {
    if (count == 0) return;
    scanner_.line();
    bytes((count + 7) / 8, place);
  } else {
    ArrayValues bits = std::vector<std::uint8_t>();
    readNumbers(scanner_, count, place, bits);
  }
}

// A line for each in text; in binary files the length comes first, in 1, 2, 4 or 8 bytes by the upper two bits of the
// first.
void VtkLegacyFile::passOverStrings(size_t count, std::string_view place) {
  scanner_.line();
  for (size_t i = 0; i < count; i++) {
    if (scanner_.atEnd()) fail(ErrorCode::Input, "{}: ends after {} strings, expected {}", place, i, count);
    if (!isBinary_) {
      scanner_.line();
      continue;
    }
    std::uint64_t length = static_cast<std::uint8_t>(bytes(1, place)[0]);
    const size_t lengthBytes = size_t{8} >> (length >> 6);
    length &= 0x3f;
    for (const char c : bytes(lengthBytes - 1, place)) length = length << 8 | static_cast<std::uint8_t>(c);
    bytes(length, place);
  }
}

// Component names and value ranges after an array, up to an empty line.
void VtkLegacyFile::passOverMetadata() {
  if (peekKeyword() != "metadata") return;
  scanner_.word();
  scanner_.line();
  while (!scanner_.atEnd() && !scanner_.line().empty()) {}
}

}  // namespace tetralux
