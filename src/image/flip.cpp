// LDR-FLIP. P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom, M. D. Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020; "the paper" below. Each
// function names the part of the paper's algorithm that it computes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <numbers>

#include "base/parallel.h"
#include "image/color.h"
#include "image/metrics.h"
#include "image/same_size.h"

namespace tetralux {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPixelsPerDegree = 67.0;  // a 0.7 m wide 3840-pixel screen seen from 0.7 m, the paper's default

// Reach of all filters in pixels: three standard deviations of the widest, that of blue-yellow (b = 0.04, see below):
// 3 * 67 * sqrt(0.04 / 2) / pi = 9.05. The feature filters end at 3 * 0.082 / 2 * 67 = 8.2, within it.
constexpr int kReach = 10;
constexpr int kFeatureReach = 9;

// Rows of one unit of work. More make fewer rows that neighbours compute twice, fewer keep the planes in the cache.
constexpr size_t kBandRows = 32;

// A filter along one axis: weights for the offsets 0, 1, ...; those of the negative offsets are `mirror` times these.
struct Filter {
  std::vector<double> weights;
  double mirror = 1.0;
};

Filter gaussian(int reach, double exponent) {
  Filter filter;
  double sum = 0.0;
  for (int x = 0; x <= reach; x++) {
    filter.weights.push_back(std::exp(-exponent * x * x));
    sum += filter.weights.back() * (x == 0 ? 1.0 : 2.0);
  }
  for (double& w : filter.weights) w /= sum;
  return filter;
}

// Spatial filtering: the contrast sensitivity of each opponent channel, a sum of a_i exp(-b_i f^2) over frequency f in
// cycles per degree, is a_i sqrt(pi/b_i) exp(-pi^2 r^2 / b_i) over the distance r in degrees. The paper evaluates that
// on the square grid of pixels and normalises the whole to sum 1. Every term is a product over x and y, so the filter
// is a sum of separable ones, each normalised here, with its share of the whole.
struct SensitivityTerm {
  double a;
  double b;  // degrees^2
};
constexpr SensitivityTerm kAchromatic{1.0, 0.0047};
constexpr SensitivityTerm kRedGreen{1.0, 0.0053};
constexpr std::array<SensitivityTerm, 2> kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};

double sensitivityExponent(const SensitivityTerm& term) {
  return kPi * kPi / (term.b * kPixelsPerDegree * kPixelsPerDegree);
}

Filter sensitivityFilter(const SensitivityTerm& term) { return gaussian(kReach, sensitivityExponent(term)); }

std::array<double, 2> blueYellowShares() {
  std::array<double, 2> shares{};
  for (size_t i = 0; i < 2; i++) {
    const SensitivityTerm& term = kBlueYellow[i];
    // gaussian() divides by the sum of its unscaled weights, whose first is 1.
    const double sum = 1.0 / sensitivityFilter(term).weights[0];
    shares[i] = term.a * std::sqrt(kPi / term.b) * sum * sum;
  }
  const double total = shares[0] + shares[1];
  return {shares[0] / total, shares[1] / total};
}

// Feature detection: first and second derivative of a Gaussian whose standard deviation is half the width w = 0.082
// degrees of human edge detectors; positive weights are scaled to sum 1, negative ones to sum -1.
constexpr double kFeatureDeviation = 0.5 * 0.082 * kPixelsPerDegree;  // pixels

Filter featureGaussian() { return gaussian(kFeatureReach, 0.5 / (kFeatureDeviation * kFeatureDeviation)); }

Filter edgeFilter() {
  Filter filter = featureGaussian();
  filter.mirror = -1.0;
  double sum = 0.0;
  for (size_t x = 0; x < filter.weights.size(); x++) {
    filter.weights[x] *= static_cast<double>(x);
    sum += filter.weights[x];
  }
  for (double& w : filter.weights) w /= sum;
  return filter;
}

Filter pointFilter() {
  Filter filter = featureGaussian();
  double positive = 0.0;
  double negative = 0.0;
  for (size_t x = 0; x < filter.weights.size(); x++) {
    const double u = static_cast<double>(x) / kFeatureDeviation;
    filter.weights[x] *= u * u - 1.0;
    (filter.weights[x] > 0.0 ? positive : negative) += std::abs(filter.weights[x]) * (x == 0 ? 1.0 : 2.0);
  }
  for (double& w : filter.weights) w /= w > 0.0 ? positive : negative;
  return filter;
}

struct Filters {
  Filter achromatic = sensitivityFilter(kAchromatic);
  Filter redGreen = sensitivityFilter(kRedGreen);
  std::array<Filter, 2> blueYellow{sensitivityFilter(kBlueYellow[0]), sensitivityFilter(kBlueYellow[1])};
  std::array<double, 2> shares = blueYellowShares();
  Filter smooth = featureGaussian();
  Filter edge = edgeFilter();
  Filter point = pointFilter();
};

// out[x] = the filter over the values that rowAt(offset)[x] gives for offsets along the filter's axis.
template <typename RowAt>
void applyFilter(const Filter& filter, size_t width, double* out, const RowAt& rowAt) {
  const double* centre = rowAt(0);
  for (size_t x = 0; x < width; x++) out[x] = filter.weights[0] * centre[x];
  for (size_t i = 1; i < filter.weights.size(); i++) {
    const double after = filter.weights[i];
    const double before = filter.mirror * after;
    const double* plus = rowAt(static_cast<std::ptrdiff_t>(i));
    const double* minus = rowAt(-static_cast<std::ptrdiff_t>(i));
    for (size_t x = 0; x < width; x++) out[x] += after * plus[x] + before * minus[x];
  }
}

// What the metric knows of a pixel.
struct Percept {
  glm::dvec3 lab;  // Hunt-adjusted L*a*b* after spatial filtering
  double edge;     // length of the edge filter's answer along x and y
  double point;    // the same for the point filter
};

// Perceptually uniform colour space: L*a*b* with a and b scaled by 0.01 L (Hunt effect).
glm::dvec3 huntLab(const glm::dvec3& rgb) {
  const glm::dvec3 lab = labFromRelativeXyz(relativeXyzFromRgb() * rgb);
  return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

// Colour of the opponent space YCxCz, which is L*a*b* without its cube roots, so that linear filters may be used.
glm::dvec3 opponentFromRgb(const glm::dvec3& rgb) {
  const glm::dvec3 xyz = relativeXyzFromRgb() * rgb;
  return {116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)};
}

glm::dvec3 rgbFromOpponent(const glm::dvec3& opponent) {
  const double y = (opponent.x + 16.0) / 116.0;
  return rgbFromRelativeXyz() * glm::dvec3(y + opponent.y / 500.0, y, y - opponent.z / 200.0);
}

double clampUnit(float value) { return value > 0.0f ? std::min(static_cast<double>(value), 1.0) : 0.0; }

// The planes that the filters along x make of the opponent colours: four for spatial filtering, three for features.
enum Plane { kA, kRg, kBy0, kBy1, kSmooth, kEdge, kPoint, kPlanes };
using Planes = std::array<std::vector<double>, kPlanes>;

// Filters rows [begin - kReach, end + kReach) along x. Outside the image the pixels of its border are repeated.
Planes filterAlongX(const Image& image, const Filters& filters, size_t begin, size_t end) {
  const size_t width = image.width;
  const size_t rows = end - begin + 2 * kReach;
  Planes planes;
  for (auto& plane : planes) plane.resize(rows * width);
  std::array<std::vector<double>, 3> padded;  // one row of Y, Cx, Cz with the border repeated
  for (auto& row : padded) row.resize(width + 2 * kReach);
  for (size_t r = 0; r < rows; r++) {
    const auto y = std::clamp<std::int64_t>(static_cast<std::int64_t>(begin + r) - kReach, 0, image.height - 1);
    for (size_t x = 0; x < width; x++) {
      const glm::vec4& pixel = image.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
      const glm::dvec3 colour = opponentFromRgb({clampUnit(pixel.r), clampUnit(pixel.g), clampUnit(pixel.b)});
      for (size_t c = 0; c < 3; c++) padded[c][kReach + x] = colour[static_cast<int>(c)];
    }
    for (auto& row : padded) {
      std::fill_n(row.begin(), kReach, row[kReach]);
      std::fill_n(row.end() - kReach, kReach, row[kReach + width - 1]);
    }
    const auto filterRow = [&](const Filter& filter, const std::vector<double>& row, Plane plane) {
      applyFilter(filter, width, planes[plane].data() + r * width,
                  [&](std::ptrdiff_t offset) { return row.data() + kReach + offset; });
    };
    filterRow(filters.achromatic, padded[0], kA);
    filterRow(filters.redGreen, padded[1], kRg);
    filterRow(filters.blueYellow[0], padded[2], kBy0);
    filterRow(filters.blueYellow[1], padded[2], kBy1);
    // Feature detection works on Y scaled to 0..1.
    for (double& value : padded[0]) value = (value + 16.0) / 116.0;
    filterRow(filters.smooth, padded[0], kSmooth);
    filterRow(filters.edge, padded[0], kEdge);
    filterRow(filters.point, padded[0], kPoint);
  }
  return planes;
}

// The percepts of rows [begin, end).
std::vector<Percept> perceiveRows(const Image& image, const Filters& filters, size_t begin, size_t end) {
  const size_t width = image.width;
  const Planes planes = filterAlongX(image, filters, begin, end);
  enum Row { kY, kCx, kCz0, kCz1, kEdgeX, kEdgeY, kPointX, kPointY, kRows };
  std::array<std::vector<double>, kRows> filtered;
  for (auto& row : filtered) row.resize(width);
  std::vector<Percept> percepts((end - begin) * width);
  for (size_t r = 0; r < end - begin; r++) {
    const auto filterAlongY = [&](const Filter& filter, Plane plane, Row row) {
      const double* centre = planes[plane].data() + (r + kReach) * width;
      applyFilter(filter, width, filtered[row].data(),
                  [&](std::ptrdiff_t offset) { return centre + offset * static_cast<std::ptrdiff_t>(width); });
    };
    filterAlongY(filters.achromatic, kA, kY);
    filterAlongY(filters.redGreen, kRg, kCx);
    filterAlongY(filters.blueYellow[0], kBy0, kCz0);
    filterAlongY(filters.blueYellow[1], kBy1, kCz1);
    filterAlongY(filters.smooth, kEdge, kEdgeX);
    filterAlongY(filters.edge, kSmooth, kEdgeY);
    filterAlongY(filters.smooth, kPoint, kPointX);
    filterAlongY(filters.point, kSmooth, kPointY);
    for (size_t x = 0; x < width; x++) {
      const double cz = filters.shares[0] * filtered[kCz0][x] + filters.shares[1] * filtered[kCz1][x];
      const glm::dvec3 rgb = rgbFromOpponent({filtered[kY][x], filtered[kCx][x], cz});
      percepts[r * width + x] = {huntLab(glm::clamp(rgb, 0.0, 1.0)),
                                 std::hypot(filtered[kEdgeX][x], filtered[kEdgeY][x]),
                                 std::hypot(filtered[kPointX][x], filtered[kPointY][x])};
    }
  }
  return percepts;
}

// Colour metric: the HyAB distance, city-block in L and Euclidean in a and b, raised to q_c = 0.7.
double colourDistance(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = a - b;
  return std::pow(std::abs(d.x) + std::hypot(d.y, d.z), 0.7);
}

// Colour metric, continued: distances up to p_c = 0.4 of the largest possible one, green against blue, are mapped to
// 0..p_t = 0.95, those above to the rest of 0..1.
double colourDifference(double distance, double largest) {
  constexpr double kShare = 0.4;
  constexpr double kMapped = 0.95;
  const double knee = kShare * largest;
  if (distance < knee) return kMapped * distance / knee;
  return kMapped + (1.0 - kMapped) * (distance - knee) / (largest - knee);
}

// Feature metric, q_f = 0.5. Each filter's answer is at most 1 along an axis, so that the difference is 0..1.
double featureDifference(const Percept& a, const Percept& b) {
  const double largest = std::max(std::abs(a.edge - b.edge), std::abs(a.point - b.point));
  return std::sqrt(std::min(1.0, largest / std::numbers::sqrt2));
}

}  // namespace

double flipError(const Image& reference, const Image& test) {
  requireSameSize(reference, test);
  static const Filters filters;
  static const double largest = colourDistance(huntLab({0.0, 1.0, 0.0}), huntLab({0.0, 0.0, 1.0}));
  const size_t bands = (reference.height + kBandRows - 1) / kBandRows;
  std::vector<double> sums(bands, 0.0);  // added up in order afterwards: the same bits with any number of threads
  parallelFor(bands, 1, [&](size_t firstBand, size_t lastBand, unsigned) {
    for (size_t band = firstBand; band < lastBand; band++) {
      const size_t begin = band * kBandRows;
      const size_t end = std::min<size_t>(begin + kBandRows, reference.height);
      const std::vector<Percept> a = perceiveRows(reference, filters, begin, end);
      const std::vector<Percept> b = perceiveRows(test, filters, begin, end);
      for (size_t i = 0; i < a.size(); i++) {
        const double colour = colourDifference(colourDistance(a[i].lab, b[i].lab), largest);
        // Final difference: features that differ raise the colour's difference towards 1.
        sums[band] += std::pow(colour, 1.0 - featureDifference(a[i], b[i]));
      }
    }
  });
  double sum = 0.0;
  for (const double s : sums) sum += s;
  return sum / static_cast<double>(reference.pixels.size());
}

}  // namespace tetralux
