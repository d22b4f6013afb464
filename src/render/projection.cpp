#include "render/projection.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.h"

namespace tetralux::render {

const std::vector<std::string>& projectionNames() {
  static const std::vector<std::string> names = {"pt", "silhouette", "gator", "march"};
  return names;
}

const char* projectionName(CellProjection projection) {
  return projectionNames()[static_cast<size_t>(projection)].c_str();
}

CellProjection parseProjection(const std::string& name) {
  const auto& names = projectionNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    fail(ErrorCode::Usage, "--projection: found '{}', expected one of {}", name, fmt::join(names, ", "));
  return static_cast<CellProjection>(found - names.begin());
}

}  // namespace tetralux::render
