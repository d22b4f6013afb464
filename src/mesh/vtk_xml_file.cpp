#include "mesh/vtk_xml_file.h"

#include <algorithm>
#include <cstring>

#include "base/error.h"
#include "base/files.h"
#include "mesh/vtk_text.h"
#include "mesh/vtk_types.h"

namespace tetralux {
namespace {

constexpr std::string_view kAppendedTag = "<AppendedData";
constexpr std::string_view kAppendedEnd = "</AppendedData>";

// Carriage returns may stay in text: arrays are the only text that is read, and to them they are white space.
constexpr unsigned kParseOptions = pugi::parse_default & ~pugi::parse_eol;

std::string_view trimmed(std::string_view text) {
  TextScanner scanner(text);
  const std::string_view word = scanner.word();
  return scanner.word().empty() ? word : text;
}

}  // namespace

std::uint64_t countAttribute(pugi::xml_node element, const char* name, std::string_view place) {
  const pugi::xml_attribute attribute = element.attribute(name);
  if (!attribute) fail(ErrorCode::Input, "{}: no {} in {}, expected a number", place, name, element.name());
  std::uint64_t count = 0;
  if (!parseNumber(trimmed(attribute.value()), count))
    fail(ErrorCode::Input, "{}: {} is '{}', expected a whole number", place, name, excerpt(attribute.value()));
  return count;
}

VtkXmlFile::VtkXmlFile(const std::filesystem::path& path, const char* type)
    : name_(path.string()), file_(readFile(path)) {
  parse();
  readAttributes(type);
}

void VtkXmlFile::parse() {
  const std::string_view file(reinterpret_cast<const char*>(file_.data()), file_.size());
  const size_t bom = file.starts_with("\xef\xbb\xbf") ? 3 : 0;
  const size_t begin = file.find_first_not_of(" \t\r\n", bom);
  if (begin == std::string_view::npos || file[begin] != '<')
    fail(ErrorCode::Input, "{}: begins with '{}', expected an XML element", name_, excerpt(file.substr(0, 8)));
  const size_t tag = file.find(kAppendedTag);
  pugi::xml_parse_result result;
  if (tag != std::string_view::npos && file.find('>', tag) != std::string_view::npos) {
    parseBeforeAppendedData(file, tag);
    result = document_.load_buffer_inplace(head_.data(), head_.size(), kParseOptions, pugi::encoding_utf8);
  } else {
    result = document_.load_buffer_inplace(file_.data(), file_.size(), kParseOptions, pugi::encoding_utf8);
  }
  if (!result)
    fail(ErrorCode::Input, "{}: byte {}: {}, expected well-formed XML", name_,
         std::min(static_cast<size_t>(result.offset), file_.size()), result.description());
}

// Appended data may be raw bytes, which no XML parser accepts: what stands before it is closed and parsed alone.
void VtkXmlFile::parseBeforeAppendedData(std::string_view file, size_t tagBegin) {
  const size_t tagEnd = file.find('>', tagBegin);
  const bool isEmpty = file[tagEnd - 1] == '/';
  head_ = file.substr(0, tagEnd);
  head_ += isEmpty ? "></VTKFile>" : "/></VTKFile>";
  if (isEmpty) return;
  const size_t underscore = file.find_first_not_of(" \t\r\n", tagEnd + 1);
  if (underscore == std::string_view::npos || file[underscore] != '_')
    fail(ErrorCode::Input, "{}: AppendedData begins with '{}', expected '_'", name_,
         excerpt(file.substr(tagEnd + 1, 8)));
  std::string_view data = file.substr(underscore + 1);
  // The closing tags are not data. They stand at the very end, and raw data may happen to hold the same characters.
  constexpr size_t kLongestEnd = 64;
  const size_t end = data.rfind(kAppendedEnd);
  if (end != std::string_view::npos && data.size() - end <= kLongestEnd) data = data.substr(0, end);
  appended_ = std::as_bytes(std::span(data));
  hasAppendedData_ = true;
}

void VtkXmlFile::readAttributes(const char* type) {
  const pugi::xml_node root = document_.document_element();
  if (std::strcmp(root.name(), "VTKFile") != 0)
    fail(ErrorCode::Input, "{}: root element is '{}', expected 'VTKFile'", name_, excerpt(root.name()));
  const char* found = root.attribute("type").value();
  if (std::strcmp(found, type) != 0)
    fail(ErrorCode::Input, "{}: VTKFile type is '{}', expected '{}'", name_, excerpt(found), type);
  dataSet_ = root.child(type);
  if (!dataSet_) fail(ErrorCode::Input, "{}: no {} in VTKFile, expected one", name_, type);
  readFormatAttributes(root);
}

void VtkXmlFile::readFormatAttributes(pugi::xml_node root) {
  const std::string_view order =
      root.attribute("byte_order").as_string(kHostIsBigEndian ? "BigEndian" : "LittleEndian");
  if (order != "LittleEndian" && order != "BigEndian")
    fail(ErrorCode::Input, "{}: byte_order is '{}', expected LittleEndian or BigEndian", name_, excerpt(order));
  packing_.swapBytes = (order == "BigEndian") != kHostIsBigEndian;

  const std::string_view header = root.attribute("header_type").as_string("UInt32");
  if (header != "UInt32" && header != "UInt64")
    fail(ErrorCode::Input, "{}: header_type is '{}', expected UInt32 or UInt64", name_, excerpt(header));
  packing_.headerSize = header == "UInt64" ? 8 : 4;

  const std::string_view compressor = root.attribute("compressor").value();
  const auto known = compressorNamed(compressor);
  if (!known)
    fail(ErrorCode::Input,
         "{}: compressor is '{}', expected vtkZLibDataCompressor, vtkLZ4DataCompressor or vtkLZMADataCompressor", name_,
         excerpt(compressor));
  packing_.compressor = *known;

  if (!hasAppendedData_) return;
  const std::string_view encoding = root.child("AppendedData").attribute("encoding").as_string("base64");
  if (encoding != "raw" && encoding != "base64")
    fail(ErrorCode::Input, "{}: encoding of AppendedData is '{}', expected raw or base64", name_, excerpt(encoding));
  appendedIsRaw_ = encoding == "raw";
}

VtkByteSource VtkXmlFile::appendedSource(pugi::xml_node dataArray, std::string_view place) const {
  if (!hasAppendedData_) fail(ErrorCode::Input, "{}: format is 'appended', expected AppendedData in the file", place);
  const std::uint64_t offset = countAttribute(dataArray, "offset", place);
  if (offset > appended_.size())
    fail(ErrorCode::Input, "{}: offset {} in appended data, expected no more than its size, {}", place, offset,
         appended_.size());
  const std::span<const std::byte> bytes = appended_.subspan(offset);
  if (appendedIsRaw_) return VtkByteSource(bytes);
  return VtkByteSource(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

ArrayValues VtkXmlFile::values(pugi::xml_node dataArray, size_t count, std::string_view place) const {
  const std::string_view type = dataArray.attribute("type").value();
  auto values = valuesOfXmlType(type);
  if (!values)
    fail(ErrorCode::Input, "{}: type is '{}', expected Int8 to Int64, UInt8 to UInt64, Float32 or Float64", place,
         excerpt(type));
  if (count == 0) return std::move(*values);  // writers differ in what they leave of an empty array
  const std::string_view format = dataArray.attribute("format").as_string("ascii");
  const std::string_view text = dataArray.child_value();
  if (format == "ascii") {
    TextScanner scanner(text);
    readNumbers(scanner, count, place, *values);
    const std::string_view rest = scanner.word();
    if (!rest.empty())
      fail(ErrorCode::Input, "{}: '{}' after the last value, expected {} values", place, excerpt(rest), count);
  } else if (format == "binary") {
    unpackNumbers(VtkByteSource(text), packing_, count, place, *values);
  } else if (format == "appended") {
    unpackNumbers(appendedSource(dataArray, place), packing_, count, place, *values);
  } else {
    fail(ErrorCode::Input, "{}: format is '{}', expected ascii, binary or appended", place, excerpt(format));
  }
  return std::move(*values);
}

}  // namespace tetralux
