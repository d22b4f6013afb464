// A named array of numbers at points or in cells, in the type it was stored in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace tetralux {

// Every number type of the VTK file formats.
using ArrayValues =
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>, std::vector<double>>;

// `components` numbers for each of tuples() points or cells, tuple after tuple.
struct DataArray {
  std::string name;
  std::uint32_t components = 1;  // >= 1
  ArrayValues values;

  size_t tuples() const { return size() / components; }
  size_t size() const;
  size_t sizeBytes() const;

  // One number as double (64-bit integers beyond 2^53 are rounded). Indices are not checked.
  double value(size_t tuple, std::uint32_t component = 0) const;

  // VTK's name of the number type: "Float32", "UInt8", ...
  const char* typeName() const;
};

}  // namespace tetralux
