// A file of VTK's XML formats: the elements, and the arrays that they hold or point to.
#pragma once

#include <filesystem>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "mesh/data_array.h"
#include "mesh/vtk_packed_array.h"

namespace tetralux {

// Reads the file and its elements; arrays are decoded when they are asked for. All members throw Error(Input).
class VtkXmlFile {
 public:
  // `type` is the kind of data set that is expected, "UnstructuredGrid".
  VtkXmlFile(const std::filesystem::path& path, const char* type);
  VtkXmlFile(const VtkXmlFile&) = delete;
  VtkXmlFile& operator=(const VtkXmlFile&) = delete;

  // The file's name, for messages.
  const std::string& name() const { return name_; }

  // The data set's element.
  pugi::xml_node dataSet() const { return dataSet_; }

  // The numbers of a <DataArray>.
  //   count   numbers it must hold: tuples x components
  //   place   begins messages
  ArrayValues values(pugi::xml_node dataArray, size_t count, std::string_view place) const;

 private:
  void parse();
  void parseBeforeAppendedData(std::string_view file, size_t tagBegin);
  void readAttributes(const char* type);
  void readFormatAttributes(pugi::xml_node root);
  VtkByteSource appendedSource(pugi::xml_node dataArray, std::string_view place) const;

  std::string name_;
  std::vector<std::byte> file_;
  std::string head_;  // the XML before appended data, closed
  pugi::xml_document document_;
  pugi::xml_node dataSet_;
  VtkPacking packing_;
  bool hasAppendedData_ = false;
  bool appendedIsRaw_ = false;
  std::span<const std::byte> appended_;  // after the underscore
};

// An attribute that holds a whole number >= 0. Throws Error(Input), beginning with `place`, where it is missing or
// holds something else.
std::uint64_t countAttribute(pugi::xml_node element, const char* name, std::string_view place);

}  // namespace tetralux
