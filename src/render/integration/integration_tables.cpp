#include "render/integration/integration_tables.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "base/check.h"
#include "base/error.h"
#include "gpu/commands.h"
#include "render/integration/incremental_table.h"
#include "render/integration/moment_pairs.h"
#include "render/pipeline_variants.h"
#include "shared/integration.h"
#include "shared/limits.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

std::uint32_t shaderValue(TableFormat format) {
  switch (format) {
    case TableFormat::Unorm8:
      return shared::TABLE_UNORM8;
    case TableFormat::Unorm16:
      return shared::TABLE_UNORM16;
    case TableFormat::F16:
      return shared::TABLE_F16;
    case TableFormat::F32:
      return shared::TABLE_F32;
  }
  checkFailed(__FILE__, __LINE__, "a table format without a shader");
}

std::uint64_t bytesPerNumber(TableFormat format) {
  return format == TableFormat::Unorm8 ? 1 : format == TableFormat::F32 ? 4 : 2;
}

bool isPreintegrated(Integration integration) { return tableChannels(integration) == 4; }

// Largest extinction (1/mesh unit) and largest channel of the luminance of a transfer function's pieces.
struct Peaks {
  float extinction = 0.0f;
  float luminance = 0.0f;
};

Peaks peaksOf(const std::vector<glm::vec4>& pieces) {
  Peaks peaks;
  for (size_t i = 0; i < pieces.size(); i += shared::TRANSFER_PIECE_TEXELS) {
    const glm::vec4& range = pieces[i];
    const float width = range.y - range.x;  // the slopes of the wide end pieces are 0
    const glm::vec3 low(pieces[i + 1]);
    const glm::vec3 high = low + glm::vec3(pieces[i + 2]) * width;
    peaks.extinction = std::max({peaks.extinction, range.z, range.z + range.w * width});
    for (int c = 0; c < 3; c++) peaks.luminance = std::max({peaks.luminance, low[c], high[c]});
  }
  return peaks;
}

// What entries are scaled by, so that they use all of the range of a fixed-point format and stay inside it.
shared::TableParameters tableParameters(Integration integration, const gpu::ImageExtent& extent,
                                        const TableInputs& inputs) {
  const Peaks peaks = peaksOf(inputs.transfer.pieceTexels());
  shared::TableParameters p{};
  p.width = extent.width;
  p.height = extent.height;
  p.depth = std::max(extent.depth, 1u);
  p.thickness = integration == Integration::Preint2d ? inputs.lengths.mean : inputs.lengths.longest;
  p.largestExtinction = peaks.extinction;
  // A table for one small thickness has small entries only (Roettger et al. 2000, section 4, scale by the largest).
  // With emission per length entries hold light per length: at most the largest emission, which has no scale of its
  // own.
  const bool perLength = inputs.transfer.emission() == Emission::PerLength;
  const float largestOpacity = -std::expm1(-p.largestExtinction * p.thickness);
  p.opacityPerValue = integration == Integration::Preint2d && largestOpacity > 0.0f ? largestOpacity : 1.0f;
  p.lightPerValue = p.opacityPerValue * std::max(1.0f, peaks.luminance);
  if (perLength) p.lightPerValue = peaks.luminance > 0.0f ? peaks.luminance : 1.0f;
  return p;
}

}  // namespace

IntegrationTables::IntegrationTables(const gpu::Context& context) : context_(context) { clear(); }

void IntegrationTables::clear() {
  table2d_ = gpu::SampledImage(context_, {1, 1, 0}, VK_FORMAT_R8G8B8A8_UNORM, "no 2-D table");
  table3d_ = gpu::SampledImage(context_, {1, 1, 1}, VK_FORMAT_R8G8B8A8_UNORM, "no 3-D table");
  channels_ = 0;
  needsFetch_ = false;
  tableBuild_.reset();
  buildMs_ = 0.0;
  bytes_ = 0;
  const gpu::Buffer texel = gpu::makeBuffer(context_, std::vector<std::uint32_t>{0}, "no table");
  gpu::CommandBuffer commands(context_);
  commands.copyToImage(texel, table2d_);
  commands.copyToImage(texel, table3d_);
  commands.submitAndWait();
  setNumbers(std::vector<glm::vec4>(shared::INTEGRATION_HEAD_TEXELS, glm::vec4(1.0f)));
}

void IntegrationTables::setNumbers(const std::vector<glm::vec4>& numbers) {
  gpu::Buffer buffer = gpu::makeBuffer(context_, numbers, "integration numbers");
  numberView_ = gpu::TexelView(context_, buffer, VK_FORMAT_R32G32B32A32_SFLOAT);
  numberBuffer_ = std::move(buffer);
}

void IntegrationTables::build(Integration integration, const TableOptions& options, const TableInputs& inputs) {
  const bool needsNumbers = integration == Integration::Moments;
  if (bytes_ > 0) clear();
  if (!needsNumbers && tableDimensions(integration) == 0) return;
  const auto start = std::chrono::steady_clock::now();
  if (needsNumbers) {
    const std::vector<glm::vec4>& pieces = inputs.transfer.pieceTexels();
    const size_t count = pieces.size() / shared::TRANSFER_PIECE_TEXELS;
    if (count > kMostMomentPieces)
      fail(ErrorCode::Input, "transfer function: {} pieces, at most {} with --integration moments", count,
           kMostMomentPieces);
    std::vector<glm::vec4> numbers(shared::INTEGRATION_HEAD_TEXELS, glm::vec4(1.0f));
    const std::vector<glm::vec4> pairs = makeMomentPairs(pieces);
    numbers.insert(numbers.end(), pairs.begin(), pairs.end());
    setNumbers(numbers);
    bytes_ = numberBuffer_.sizeBytes();
  } else {
    buildImage(integration, options, inputs);
  }
  buildMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Devices need not have 16-bit integers between 0 and 1; all have 32-bit floats, if without interpolation.
TableFormat IntegrationTables::defaultFormat(int channels) const {
  return gpu::filtersLinearly(context_, imageFormat(TableFormat::Unorm16, channels)) ? TableFormat::Unorm16
                                                                                     : TableFormat::F32;
}

void IntegrationTables::buildImage(Integration integration, const TableOptions& options, const TableInputs& inputs) {
  extent_ = tableExtent(integration, options);
  channels_ = tableChannels(integration);
  format_ = options.format.value_or(defaultFormat(channels_));
  const VkFormat format = imageFormat(format_, channels_);
  needsFetch_ = options.forceFetch || !gpu::filtersLinearly(context_, format);
  gpu::SampledImage image(context_, extent_, format, std::string(integrationName(integration)) + " table");

  // The shaders store four numbers at a time; those behind a table's last entry are not copied.
  const std::uint64_t fours = (extent_.texels() * static_cast<std::uint64_t>(channels_) + 3) / 4;
  const gpu::Buffer words(context_, fours * 4 * bytesPerNumber(format_), gpu::MemoryKind::Device, "table words");
  const shared::TableParameters parameters = tableParameters(integration, extent_, inputs);
  const gpu::SpecConstants constants = {
      {SPEC_TABLE_FORMAT, shaderValue(format_)},
      {SPEC_EMISSION_PER_LENGTH, inputs.transfer.emission() == Emission::PerLength},
      {SPEC_INTEGRATION,
       integration == Integration::Preint3d ? shared::INTEGRATION_PREINT3D : shared::INTEGRATION_PREINT3D_LOG}};
  gpu::CommandBuffer commands(context_);
  ComputeVariants shader(context_, integration == Integration::Ppi         ? "tables/psi.comp"
                                   : integration == Integration::Opacity2d ? "tables/opacity.comp"
                                                                           : "tables/preintegrate.comp");
  if (extent_.depth > 0) tableBuild_ = options.build;
  std::optional<IncrementalTable> incremental;
  if (tableBuild_ == TableBuild::Incremental)
    incremental.emplace(context_, parameters, constants).record(commands, inputs.transfer, words);
  else if (isPreintegrated(integration))
    commands.dispatch(shader.get(constants), {words, inputs.transfer.pieces(), inputs.transfer.pieceBins()}, parameters,
                      fours);
  else
    commands.dispatch(shader.get(constants), {words}, parameters, fours);
  commands.barrier(gpu::access::kComputeWrite, gpu::access::kTransferRead);
  commands.copyToImage(words, image);
  commands.submitAndWait();

  bytes_ = image.sizeBytes();
  (extent_.depth == 0 ? table2d_ : table3d_) = std::move(image);
  valuePerEntry_ = glm::vec4(glm::vec3(parameters.lightPerValue), parameters.opacityPerValue);
  setNumbers({glm::vec4(parameters.thickness, parameters.largestExtinction, parameters.lightPerValue,
                        parameters.opacityPerValue)});
}

std::vector<glm::vec4> IntegrationTables::read() const {
  CHECK(channels_ > 0);
  const gpu::SampledImage& image = extent_.depth == 0 ? table2d_ : table3d_;
  const std::uint64_t numbers = extent_.texels() * static_cast<std::uint64_t>(channels_);
  const gpu::Buffer buffer(context_, numbers * bytesPerNumber(format_), gpu::MemoryKind::Readback, "table");
  gpu::CommandBuffer commands(context_);
  commands.copyToBuffer(image, buffer);
  commands.barrier(gpu::access::kTransferWrite, gpu::access::kHostRead);
  commands.submitAndWait();

  const auto number = [&](std::uint64_t i) {
    switch (format_) {
      case TableFormat::Unorm8:
        return glm::unpackUnorm1x8(buffer.as<std::uint8_t>()[i]);
      case TableFormat::Unorm16:
        return glm::unpackUnorm1x16(buffer.as<std::uint16_t>()[i]);
      case TableFormat::F16:
        return glm::unpackHalf1x16(buffer.as<std::uint16_t>()[i]);
      default:
        return buffer.as<float>()[i];
    }
  };
  std::vector<glm::vec4> entries(extent_.texels());
  for (std::uint64_t i = 0; i < entries.size(); i++)
    entries[i] = valuePerEntry_ *
                 (channels_ == 1 ? glm::vec4(glm::vec3(number(i)), 1.0f)
                                 : glm::vec4(number(4 * i), number(4 * i + 1), number(4 * i + 2), number(4 * i + 3)));
  return entries;
}

}  // namespace tetralux::render
