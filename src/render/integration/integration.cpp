#include "render/integration/integration.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <charconv>

#include "base/check.h"
#include "base/error.h"
#include "shared/integration.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

constexpr std::uint32_t kLargestSide = 4096;

size_t indexOf(const std::vector<std::string>& names, const std::string& name, const char* option) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    fail(ErrorCode::Usage, "{}: found '{}', expected one of {}", option, name, fmt::join(names, ", "));
  return static_cast<size_t>(found - names.begin());
}

std::uint32_t shaderValue(Integration integration) {
  switch (integration) {
    case Integration::Exact:
      return shared::INTEGRATION_EXACT;
    case Integration::Moments:
      return shared::INTEGRATION_MOMENTS;
    case Integration::Linear:
      return shared::INTEGRATION_LINEAR;
    case Integration::Ppi:
      return shared::INTEGRATION_PPI;
    case Integration::Average:
      return shared::INTEGRATION_AVERAGE;
    case Integration::Vertex:
      return shared::INTEGRATION_VERTEX;
    case Integration::Opacity2d:
      return shared::INTEGRATION_OPACITY2D;
    case Integration::Preint2d:
      return shared::INTEGRATION_PREINT2D;
    case Integration::Preint3d:
      return shared::INTEGRATION_PREINT3D;
    case Integration::Preint3dLog:
      return shared::INTEGRATION_PREINT3D_LOG;
    case Integration::Preint3dOctave:
      return shared::INTEGRATION_PREINT3D_OCTAVE;
  }
  checkFailed(__FILE__, __LINE__, "an integration without a shader");
}

std::uint32_t shaderValue(PartAccuracy accuracy) {
  static constexpr std::uint32_t kValues[] = {shared::PART_FULL, shared::PART_FINE, shared::PART_MEDIUM,
                                              shared::PART_COARSE};
  return kValues[static_cast<size_t>(accuracy)];
}

}  // namespace

const char* partAccuracyName(PartAccuracy accuracy) {
  static constexpr const char* kNames[] = {"full", "fine", "medium", "coarse"};
  return kNames[static_cast<size_t>(accuracy)];
}

PartError partError(PartAccuracy accuracy) {
  static constexpr PartError kErrors[] = {{1e-7, 3.2e-6}, {3.8e-6, 1.3e-4}, {5.5e-5, 9.9e-4}, {1.2e-3, 1.6e-2}};
  return kErrors[static_cast<size_t>(accuracy)];
}

const std::vector<std::string>& integrationNames() {
  // In the order of the enumeration.
  static const std::vector<std::string> names = {"exact",    "moments",      "linear",         "ppi",
                                                 "average",  "vertex",       "opacity2d",      "preint2d",
                                                 "preint3d", "preint3d-log", "preint3d-octave"};
  return names;
}

const char* integrationName(Integration integration) {
  return integrationNames()[static_cast<size_t>(integration)].c_str();
}

Integration parseIntegration(const std::string& name) {
  return static_cast<Integration>(indexOf(integrationNames(), name, "--integration"));
}

const std::vector<std::string>& interpolationNames() {
  static const std::vector<std::string> names = {"perspective", "screen"};
  return names;
}

const char* interpolationName(Interpolation interpolation) {
  return interpolationNames()[static_cast<size_t>(interpolation)].c_str();
}

Interpolation parseInterpolation(const std::string& name) {
  return static_cast<Interpolation>(indexOf(interpolationNames(), name, "--interpolation"));
}

const std::vector<std::string>& tableFormatNames() {
  static const std::vector<std::string> names = {"unorm8", "unorm16", "f16", "f32"};
  return names;
}

const char* tableFormatName(TableFormat format) { return tableFormatNames()[static_cast<size_t>(format)].c_str(); }

TableFormat parseTableFormat(const std::string& name) {
  return static_cast<TableFormat>(indexOf(tableFormatNames(), name, "--table-format"));
}

const std::vector<std::string>& tableBuildNames() {
  static const std::vector<std::string> names = {"exact", "incremental"};
  return names;
}

const char* tableBuildName(TableBuild build) { return tableBuildNames()[static_cast<size_t>(build)].c_str(); }

TableBuild parseTableBuild(const std::string& name) {
  return static_cast<TableBuild>(indexOf(tableBuildNames(), name, "--table-build"));
}

bool carriesEmissionPerLength(Integration integration) {
  return integration != Integration::Moments && integration != Integration::Ppi;
}

int tableDimensions(Integration integration) {
  switch (integration) {
    case Integration::Ppi:
    case Integration::Opacity2d:
    case Integration::Preint2d:
      return 2;
    case Integration::Preint3d:
    case Integration::Preint3dLog:
    case Integration::Preint3dOctave:
      return 3;
    default:
      return 0;
  }
}

int tableChannels(Integration integration) {
  return integration == Integration::Ppi || integration == Integration::Opacity2d ? 1 : 4;
}

std::array<std::uint32_t, 3> parseTableSize(const std::string& text) {
  std::array<std::uint32_t, 3> size = {0, 0, 0};
  const char* at = text.data();
  const char* const end = at + text.size();
  bool isGood = !text.empty();
  for (std::uint32_t& side : size) {
    const auto [stop, error] = std::from_chars(at, end, side);
    isGood = isGood && error == std::errc() && side >= 2 && side <= kLargestSide;
    at = stop;
    if (!isGood || at == end) break;
    isGood = *at++ == 'x';
  }
  if (!isGood || at != end)
    fail(ErrorCode::Usage, "--table-size: found '{}', expected N, NxM or NxMxL with numbers from 2 to {}", text,
         kLargestSide);
  return size;
}

gpu::ImageExtent tableExtent(Integration integration, const TableOptions& options) {
  const int dimensions = tableDimensions(integration);
  CHECK(dimensions > 0);
  const std::uint32_t side = integration == Integration::Ppi ? 512 : dimensions == 2 ? 256 : 128;
  constexpr std::uint32_t kSlices = 32;
  const auto& [width, height, depth] = options.size;
  gpu::ImageExtent extent;
  extent.width = width > 0 ? width : side;
  extent.height = height > 0 ? height : extent.width;
  extent.depth = dimensions == 2 ? 0 : depth > 0 ? depth : kSlices;
  return extent;
}

VkFormat imageFormat(TableFormat format, int channels) {
  const bool isOne = channels == 1;
  switch (format) {
    case TableFormat::Unorm8:
      return isOne ? VK_FORMAT_R8_UNORM : VK_FORMAT_R8G8B8A8_UNORM;
    case TableFormat::Unorm16:
      return isOne ? VK_FORMAT_R16_UNORM : VK_FORMAT_R16G16B16A16_UNORM;
    case TableFormat::F16:
      return isOne ? VK_FORMAT_R16_SFLOAT : VK_FORMAT_R16G16B16A16_SFLOAT;
    case TableFormat::F32:
      return isOne ? VK_FORMAT_R32_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT;
  }
  checkFailed(__FILE__, __LINE__, "a table format without an image format");
}

gpu::SpecConstants IntegrationVariant::specConstants() const {
  return {{SPEC_INTEGRATION, shaderValue(integration)},
          {SPEC_INTERPOLATION,
           interpolation == Interpolation::Screen ? shared::INTERPOLATION_SCREEN : shared::INTERPOLATION_PERSPECTIVE},
          {SPEC_TABLE_FETCH, tableFetch},
          {SPEC_PART_ACCURACY, shaderValue(accuracy)},
          {SPEC_LEAST_TRANSMITTANCE, std::bit_cast<std::uint32_t>(leastTransmittance)}};
}

}  // namespace tetralux::render
