#include "render/transfer_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "shared/limits.h"

namespace tetralux::render {
namespace {

using shared::TRANSFER_BINS;

// How far the end pieces reach; the shaders add and subtract it, which must not overflow.
constexpr float kFarAway = 1e30f;

// A piece in the device's units and precision.
struct DevicePiece {
  float low, high;
  OpticalSample atLow, atHigh;  // extinction, and emission per length, per mesh unit
};

// What decides whether a scalar shows, and how much a wrong thickness would: extinction, or with emission per length
// the brightest channel if that is more.
double strength(const OpticalSample& sample, Emission emission) {
  if (emission == Emission::PerExtinction) return sample.extinction;
  return std::max({sample.extinction, sample.luminance.x, sample.luminance.y, sample.luminance.z});
}

std::vector<DevicePiece> devicePieces(const TransferFunction& transfer, const MeshSpace& space) {
  std::vector<DevicePiece> result;
  for (const TransferPiece& piece : transfer.pieces()) {
    DevicePiece p{std::isinf(piece.low) ? -kFarAway : space.scalar(piece.low),
                  std::isinf(piece.high) ? kFarAway : space.scalar(piece.high), piece.atLow, piece.atHigh};
    p.atLow.extinction *= space.scale;
    p.atHigh.extinction *= space.scale;
    if (transfer.emission() == Emission::PerLength) {
      p.atLow.luminance *= space.scale;
      p.atHigh.luminance *= space.scale;
    }
    if (p.low < p.high) result.push_back(p);
  }
  return result;
}

void addTexels(const DevicePiece& p, std::vector<glm::vec4>& texels) {
  const bool isEnd = p.low == -kFarAway || p.high == kFarAway;
  const double width = static_cast<double>(p.high) - static_cast<double>(p.low);
  const double perScalar = isEnd ? 0.0 : 1.0 / width;
  const double slope = (p.atHigh.extinction - p.atLow.extinction) * perScalar;
  const glm::dvec3 luminanceSlope = (p.atHigh.luminance - p.atLow.luminance) * perScalar;
  texels.emplace_back(p.low, p.high, static_cast<float>(p.atLow.extinction), static_cast<float>(slope));
  texels.emplace_back(glm::vec3(p.atLow.luminance), 0.0f);
  texels.emplace_back(glm::vec3(luminanceSlope), 0.0f);
}

// The ends of all pieces, those that two pieces share once.
void listPoints(const std::vector<DevicePiece>& pieces, TransferTables& tables) {
  float last = -kFarAway;
  const auto add = [&](float scalar, const OpticalSample& sample) {
    const glm::vec4 point(glm::vec3(sample.luminance), static_cast<float>(sample.extinction));
    if (!tables.points.empty()) {
      if (last == scalar && tables.points.back() == point) return;
      tables.pointScalars.emplace_back(last, scalar);
    }
    tables.points.push_back(point);
    last = scalar;
  };
  for (const DevicePiece& p : pieces) {
    add(p.low, p.atLow);
    add(p.high, p.atHigh);
  }
}

// Pieces next to each other with something to see inside become one interval.
std::vector<glm::vec4> supportIntervals(const std::vector<DevicePiece>& pieces, Emission emission) {
  std::vector<glm::vec4> result;
  for (const DevicePiece& p : pieces) {
    const double atLow = strength(p.atLow, emission);
    if (atLow == 0.0 && strength(p.atHigh, emission) == 0.0) continue;
    // At a step up, a scalar exactly on the step already shows.
    const float low = atLow > 0.0 ? std::nextafter(p.low, -std::numeric_limits<float>::infinity()) : p.low;
    if (!result.empty() && result.back().y >= low)
      result.back().y = p.high;
    else
      result.emplace_back(low, p.high, 0.0f, 0.0f);
  }
  return result;
}

// A sparse table for range maxima (Bender and Farach-Colton 2000): entry b of level l covers 2^l bins from bin b on.
std::vector<float> largestStrengths(const std::vector<DevicePiece>& pieces, Emission emission) {
  std::vector<float> table(std::size_t{shared::EXTINCTION_LEVELS} * TRANSFER_BINS, 0.0f);
  for (std::uint32_t bin = 0; bin < TRANSFER_BINS; bin++) {
    // The shader's bin of a scalar may be one off by rounding at the bin's ends; scalars beyond the range are in the
    // end bins.
    const float low = bin == 0 ? -kFarAway : (static_cast<float>(bin) - 0.01f) / TRANSFER_BINS - 0.5f;
    const float high = bin + 1 == TRANSFER_BINS ? kFarAway : (static_cast<float>(bin) + 1.01f) / TRANSFER_BINS - 0.5f;
    for (const DevicePiece& p : pieces) {
      if (p.high < low || p.low > high) continue;
      const auto at = [&](float s) {
        const double t = (static_cast<double>(s) - double{p.low}) / (double{p.high} - double{p.low});
        const double atLow = strength(p.atLow, emission);
        return static_cast<float>(atLow + t * (strength(p.atHigh, emission) - atLow));
      };
      table[bin] = std::max({table[bin], at(std::max(low, p.low)), at(std::min(high, p.high))});
    }
  }
  for (std::uint32_t level = 1; level < shared::EXTINCTION_LEVELS; level++) {
    const float* below = table.data() + (level - 1) * TRANSFER_BINS;
    for (std::uint32_t bin = 0; bin < TRANSFER_BINS; bin++)
      table[level * TRANSFER_BINS + bin] =
          std::max(below[bin], below[std::min(bin + (1u << (level - 1)), TRANSFER_BINS - 1)]);
  }
  return table;
}

template <typename T>
std::vector<T> atLeastOne(std::vector<T> values) {
  if (values.empty()) values.emplace_back(0);
  return values;
}

}  // namespace

TransferTables makeTransferTables(const TransferFunction& transfer, const MeshSpace& space) {
  const std::vector<DevicePiece> pieces = devicePieces(transfer, space);
  TransferTables tables;
  for (const DevicePiece& p : pieces) addTexels(p, tables.pieces);
  listPoints(pieces, tables);
  const auto pieceAt = [&](float s) {
    const auto after = std::upper_bound(pieces.begin(), pieces.end(), s,
                                        [](float value, const DevicePiece& p) { return value < p.low; });
    return static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(after - pieces.begin(), 1) - 1);
  };
  for (std::uint32_t bin = 0; bin < TRANSFER_BINS; bin++) {
    const float low = static_cast<float>(bin) / TRANSFER_BINS - 0.5f;
    const float high = static_cast<float>(bin + 1) / TRANSFER_BINS - 0.5f;
    // The shader's bin of a scalar may be one off by rounding at the bin's ends.
    tables.pieceBins.push_back(pieceAt(std::nextafter(low, -1.0f)));
    tables.pieceBins.push_back(pieceAt(std::nextafter(high, 1.0f)));
  }
  tables.largestExtinction = largestStrengths(pieces, transfer.emission());
  tables.support = supportIntervals(pieces, transfer.emission());
  return tables;
}

bool coversField(const std::vector<glm::vec4>& support) {
  // Normalised scalars are within 1/2 of 0, up to rounding.
  return std::any_of(support.begin(), support.end(),
                     [](const glm::vec4& interval) { return interval.x < -1.0f && interval.y > 1.0f; });
}

void TransferBuffer::set(const TransferFunction& transfer, const MeshSpace& space) {
  const TransferTables made = makeTransferTables(transfer, space);
  emission_ = transfer.emission();
  largest_ = *std::max_element(made.largestExtinction.begin(), made.largestExtinction.end());
  supportCount_ = static_cast<std::uint32_t>(made.support.size());
  pieceTexels_ = made.pieces;
  pointTexels_ = made.points;
  pointScalarTexels_ = made.pointScalars;
  support_ = made.support;
  const std::vector<glm::vec4> support = atLeastOne(made.support);
  const std::array<gpu::TableView, 6> views = {
      {{&pieceView_, VK_FORMAT_R32G32B32A32_SFLOAT, gpu::bytesOf(made.pieces)},
       {&binView_, VK_FORMAT_R32_UINT, gpu::bytesOf(made.pieceBins)},
       {&pointView_, VK_FORMAT_R32G32B32A32_SFLOAT, gpu::bytesOf(made.points)},
       {&pointScalarView_, VK_FORMAT_R32G32_SFLOAT, gpu::bytesOf(made.pointScalars)},
       {&extinctionView_, VK_FORMAT_R32_SFLOAT, gpu::bytesOf(made.largestExtinction)},
       {&supportView_, VK_FORMAT_R32G32B32A32_SFLOAT, gpu::bytesOf(support)}}};
  tables_.set(context_, views, "transfer function");
}

}  // namespace tetralux::render
