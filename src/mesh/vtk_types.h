// Number and cell types of the VTK file formats.
#pragma once

#include <bit>
#include <cstddef>
#include <optional>
#include <string_view>

#include "mesh/data_array.h"

namespace tetralux {

// VTK_TETRA
constexpr int kTetrahedronType = 10;

// VTK's name of a cell type in words; "unknown" beyond those that files hold.
const char* cellTypeName(std::int64_t type);

// Empty values of the type that a DataArray element's attribute names ("Float32", ...); none for any other name.
std::optional<ArrayValues> valuesOfXmlType(std::string_view name);

// The same for the legacy format, whatever the case ("float", "unsigned_char", ...).
std::optional<ArrayValues> valuesOfLegacyType(std::string_view name);

// Bytes of one number.
size_t numberSize(const ArrayValues& values);

// Turns the byte order of `count` numbers of `width` bytes (1, 2, 4 or 8) round.
void swapBytes(void* numbers, size_t count, size_t width);

constexpr bool kHostIsBigEndian = std::endian::native == std::endian::big;

// `tuples` x `components`, or nothing where that many numbers of any type cannot be addressed.
std::optional<size_t> numberCount(size_t tuples, size_t components);

}  // namespace tetralux
