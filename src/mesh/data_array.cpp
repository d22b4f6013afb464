#include "mesh/data_array.h"

#include <type_traits>

namespace tetralux {
namespace {

template <typename T>
constexpr const char* vtkTypeName() {
  if constexpr (std::is_same_v<T, float>)
    return "Float32";
  else if constexpr (std::is_same_v<T, double>)
    return "Float64";
  else if constexpr (std::is_same_v<T, std::int8_t>)
    return "Int8";
  else if constexpr (std::is_same_v<T, std::uint8_t>)
    return "UInt8";
  else if constexpr (std::is_same_v<T, std::int16_t>)
    return "Int16";
  else if constexpr (std::is_same_v<T, std::uint16_t>)
    return "UInt16";
  else if constexpr (std::is_same_v<T, std::int32_t>)
    return "Int32";
  else if constexpr (std::is_same_v<T, std::uint32_t>)
    return "UInt32";
  else if constexpr (std::is_same_v<T, std::int64_t>)
    return "Int64";
  else
    return "UInt64";
}

}  // namespace

size_t DataArray::size() const {
  return std::visit([](const auto& v) { return v.size(); }, values);
}

size_t DataArray::sizeBytes() const {
  return std::visit([](const auto& v) { return v.size() * sizeof v[0]; }, values);
}

double DataArray::value(size_t tuple, std::uint32_t component) const {
  const size_t i = tuple * components + component;
  return std::visit([i](const auto& v) { return static_cast<double>(v[i]); }, values);
}

const char* DataArray::typeName() const {
  return std::visit([](const auto& v) { return vtkTypeName<typename std::decay_t<decltype(v)>::value_type>(); },
                    values);
}

}  // namespace tetralux
