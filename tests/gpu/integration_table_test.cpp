// Tables as they are stored, entry by entry, and what they depend on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gpu_fixture.h"
#include "reference/segment_integral.h"
#include "segments.h"
#include "support/expect_error.h"

namespace tetralux::render {
namespace {

using test::errorOf;
using test::GpuTest;
using test::unitSpace;

const TransferFunction& ramp() {
  static const TransferFunction transfer({{0, {1, 0, 0.5}, 0}, {1, {0, 1, 0.5}, 4}}, "ramp");
  return transfer;
}

struct BuiltTable {
  std::vector<glm::vec4> entries;
  gpu::ImageExtent extent;

  const glm::vec4& at(std::uint32_t x, std::uint32_t y, std::uint32_t z = 0) const {
    return entries[(size_t{z} * extent.height + y) * extent.width + x];
  }
};

BuiltTable buildTable(const gpu::Context& context, Integration integration, const TableOptions& options,
                      const TransferFunction& transfer = ramp(), const CellLengths& lengths = {}) {
  const TransferBuffer pieces(context, transfer, unitSpace());
  IntegrationTables tables(context);
  tables.build(integration, options, {pieces, lengths});
  EXPECT_GT(tables.buildMs(), 0.0);
  return {tables.read(), tables.extent()};
}

TableOptions sized(std::uint32_t x, std::uint32_t y, std::uint32_t z, TableFormat format) {
  TableOptions options;
  options.size = {x, y, z};
  options.format = format;
  return options;
}

// Psi by Romberg's rule in 64-bit (or better) significands, over panels of u: nothing in common with the shader's rule.
long double psi(long double a, long double b) {
  const auto f = [&](long double u) { return std::exp(-(b * u * (1.0L - 0.5L * u) + 0.5L * a * u * u)); };
  constexpr int kPanels = 64;
  constexpr int kRows = 7;
  long double sum = 0.0L;
  for (int panel = 0; panel < kPanels; panel++) {
    // Panels become narrow towards the eye, where an opaque segment ends.
    const auto place = [&](int k) { return std::pow(static_cast<long double>(k) / kPanels, 4.0L); };
    const long double low = place(panel), width = place(panel + 1) - low;
    long double row[kRows];
    int intervals = 1;
    long double trapezoid = 0.5L * width * (f(low) + f(low + width));
    row[0] = trapezoid;
    for (int k = 1; k < kRows; k++) {
      long double middle = 0.0L;
      for (int i = 0; i < intervals; i++) middle += f(low + width * (2 * i + 1) / (2 * intervals));
      trapezoid = 0.5L * (trapezoid + width / intervals * middle);
      intervals *= 2;
      long double above = row[0], power = 1.0L;
      row[0] = trapezoid;
      for (int j = 1; j <= k; j++) {
        power *= 4.0L;
        const long double next = row[j - 1] + (row[j - 1] - above) / (power - 1.0L);
        above = row[j];
        row[j] = next;
      }
    }
    sum += row[kRows - 1];
  }
  return sum;
}

TEST_F(GpuTest, PsiTableHoldsTheIntegralAtItsNodes) {
  constexpr std::uint32_t kSize = 512;
  const BuiltTable table = buildTable(context(), Integration::Ppi, sized(kSize, kSize, 0, TableFormat::F32));
  double worst = 0.0;
  for (std::uint32_t y = 0; y < kSize; y += y < 8 || y > 496 ? 1 : 7) {
    for (std::uint32_t x = 0; x < kSize; x += x < 8 || x > 496 ? 1 : 7) {
      const bool isInfinite = x == kSize - 1 || y == kSize - 1;
      const auto depth = [&](std::uint32_t i) { return static_cast<long double>(i) / (kSize - 1 - i); };
      const long double expected = isInfinite ? 0.0L : psi(depth(x), depth(y));
      worst = std::max(worst, std::abs(static_cast<double>(expected) - static_cast<double>(table.at(x, y).x)));
    }
  }
  EXPECT_LE(worst, 1e-6);
}

// Williams and Max (1992): for a > b, Psi = sqrt(pi)/(2 sqrt c) exp(y^2) (erfc(y) - erfc(x)), c = (a - b)/2, x = a/(2
// sqrt c), y = b/(2 sqrt c). In 64-bit significands it holds up to large y, where single precision has long lost it.
long double closedPsi(long double a, long double b) {
  const long double root = std::sqrt(0.5L * (a - b));
  const long double x = 0.5L * a / root, y = 0.5L * b / root;
  return 0.5L * std::sqrt(std::numbers::pi_v<long double>) / root * std::exp(y * y) * (std::erfc(y) - std::erfc(x));
}

// Two answers that have nothing in common agree, so each of them is one.
TEST(Psi, QuadratureAgreesWithThePublishedClosedForm) {
  for (const long double a : {1e-3L, 0.5L, 3.0L, 60.0L, 510.0L}) {
    EXPECT_NEAR(static_cast<double>(psi(a, a) / (-std::expm1(-a) / a)), 1.0, 1e-12);
    for (const long double share : {0.0L, 0.2L, 0.7L})
      EXPECT_NEAR(static_cast<double>(psi(a, share * a) / closedPsi(a, share * a)), 1.0, 1e-12)
          << static_cast<double>(a);
  }
}

// Every node on the diagonal and, by the closed form, all that it is well-conditioned for on one side of it.
TEST_F(GpuTest, PsiTableHoldsThePublishedClosedForms) {
  constexpr std::uint32_t kSize = 512;
  const BuiltTable table = buildTable(context(), Integration::Ppi, sized(kSize, kSize, 0, TableFormat::F32));
  const auto depth = [](std::uint32_t i) { return static_cast<long double>(i) / (kSize - 1 - i); };
  double worst = 0.0;
  std::uint32_t compared = 0;
  for (std::uint32_t i = 1; i + 1 < kSize; i++) {
    const long double a = depth(i);
    worst = std::max(worst, std::abs(static_cast<double>(-std::expm1(-a) / a) - static_cast<double>(table.at(i, i).x)));
    for (std::uint32_t j = 0; j < i; j++) {
      const long double b = depth(j);
      if (0.5L * b * b / (a - b) > 2000.0L) continue;
      worst = std::max(worst, std::abs(static_cast<double>(closedPsi(a, b)) - static_cast<double>(table.at(i, j).x)));
      compared++;
    }
  }
  EXPECT_GT(compared, 100000u);
  EXPECT_LE(worst, 1e-6);
}

// What Moreland and Angel (2004) say of Psi: figure 7 and the definition of gamma as Psi's likeness. Their table itself
// is no longer to be had.
TEST_F(GpuTest, PsiTableHasThePublishedProperties) {
  const BuiltTable table = buildTable(context(), Integration::Ppi, sized(101, 0, 0, TableFormat::F32));
  EXPECT_EQ(table.extent.height, 101u);
  EXPECT_NEAR(table.at(0, 0).x, 1.0f, 1e-6f);
  // Equal extinctions: (1 - exp(-m))/m. gamma = 1/2 is an optical depth of 1.
  EXPECT_NEAR(table.at(50, 50).x, 1.0 - std::exp(-1.0), 1e-6);
  // No extinction at the eye's end: sqrt(pi/(2 a)) erf(sqrt(a/2)); none at the far end: sqrt(2/b) Dawson(sqrt(b/2)).
  EXPECT_NEAR(table.at(50, 0).x, std::sqrt(M_PI / 2.0) * std::erf(std::sqrt(0.5)), 1e-6);
  EXPECT_NEAR(table.at(0, 50).x, std::sqrt(2.0) * 0.5124957632211032, 1e-6);
  for (std::uint32_t i = 1; i < 101; i++) {
    for (std::uint32_t j = 0; j < 101; j++) {
      EXPECT_LE(table.at(i, j).x, table.at(i - 1, j).x + 1e-6f);
      EXPECT_LE(table.at(j, i).x, table.at(j, i - 1).x + 1e-6f);
    }
  }
}

TEST_F(GpuTest, TablesKeepTheirEntriesInEveryFormat) {
  const BuiltTable exact = buildTable(context(), Integration::Ppi, sized(33, 17, 0, TableFormat::F32));
  const std::pair<TableFormat, float> steps[] = {
      {TableFormat::Unorm8, 0.51f / 255}, {TableFormat::Unorm16, 0.51f / 65535}, {TableFormat::F16, 1.01f / 2048}};
  for (const auto& [format, step] : steps) {
    const BuiltTable table = buildTable(context(), Integration::Ppi, sized(33, 17, 0, format));
    ASSERT_EQ(table.entries.size(), 33u * 17u);
    for (size_t i = 0; i < table.entries.size(); i++)
      ASSERT_NEAR(table.entries[i].x, exact.entries[i].x, step) << tableFormatName(format) << " " << i;
  }
}

TEST_F(GpuTest, OpacityTableHoldsOpacity) {
  CellLengths lengths;
  lengths.longest = 3.0f;
  const BuiltTable table =
      buildTable(context(), Integration::Opacity2d, sized(11, 7, 0, TableFormat::F32), ramp(), lengths);
  for (std::uint32_t y = 0; y < 7; y++) {
    for (std::uint32_t x = 0; x < 11; x++)
      EXPECT_NEAR(table.at(x, y).x, -std::expm1(-4.0 * x / 10.0 * 3.0 * y / 6.0), 2e-7);
  }
}

// Slices of the logarithmic table: 0, then powers of two up to the largest thickness (Kraus et al. 2004, figure 6).
TEST_F(GpuTest, PreintegratedTablesHoldTheIntegral) {
  CellLengths lengths;
  lengths.longest = 2.0f;
  lengths.mean = 0.25f;
  struct Case {
    Integration integration;
    double (*share)(std::uint32_t slice, std::uint32_t slices);
  };
  const Case cases[] = {
      {Integration::Preint3d, [](std::uint32_t k, std::uint32_t n) { return static_cast<double>(k) / (n - 1); }},
      {Integration::Preint3dLog,
       [](std::uint32_t k, std::uint32_t n) { return k == 0 ? 0.0 : std::exp2(static_cast<double>(k) - n + 1); }},
      {Integration::Preint2d, [](std::uint32_t, std::uint32_t) { return 1.0; }}};
  // A luminance above 1 and a control point that no entry lies on.
  const TransferFunction transfer({{0, {3, 0, 0.5}, 0}, {0.43, {0, 1, 0.5}, 9}, {1, {0.5, 0, 1}, 1}}, "t");
  for (const Case& c : cases) {
    const BuiltTable table = buildTable(context(), c.integration, sized(9, 9, 8, TableFormat::F32), transfer, lengths);
    const bool isMean = c.integration == Integration::Preint2d;
    for (std::uint32_t z = 0; z < std::max(table.extent.depth, 1u); z++) {
      for (std::uint32_t y = 0; y < 9; y++) {
        for (std::uint32_t x = 0; x < 9; x++) {
          const double thickness = isMean ? 0.25 : 2.0 * c.share(z, 8);
          const SegmentOptics expected = reference::integrateSegment(transfer, x / 8.0, y / 8.0, thickness);
          const glm::vec4& found = table.at(x, y, z);
          EXPECT_NEAR(found.w, expected.alpha, 1e-5);
          EXPECT_NEAR(found.x, expected.light.x, 2e-5);
        }
      }
    }
  }
}

TEST_F(GpuTest, TablesAreBuiltOnlyForTheMethodsThatHaveOne) {
  const TransferBuffer pieces(context(), ramp(), unitSpace());
  IntegrationTables tables(context());
  for (const Integration integration :
       {Integration::Exact, Integration::Linear, Integration::Average, Integration::Vertex}) {
    tables.build(integration, {}, {pieces, {}});
    EXPECT_EQ(tables.buildMs(), 0.0);
    EXPECT_EQ(tables.sizeBytes(), 0u);
  }
  tables.build(Integration::Preint3d, {}, {pieces, {}});
  EXPECT_GE(tables.sizeBytes(), 128u * 128u * 32u * 8u);
  tables.build(Integration::Exact, {}, {pieces, {}});
  EXPECT_EQ(tables.sizeBytes(), 0u);
}

TEST_F(GpuTest, TooManyPiecesForMomentsAreAnError) {
  std::vector<ControlPoint> points;
  for (int i = 0; i < 1100; i++) points.push_back({i / 1099.0, {1, 1, 1}, i % 2 * 1.0});
  const TransferBuffer pieces(context(), TransferFunction(points, "t"), unitSpace());
  IntegrationTables tables(context());
  EXPECT_EQ(errorOf(ErrorCode::Input,
                    [&] {
                      tables.build(Integration::Moments, {}, {pieces, {}});
                    }),
            "transfer function: 1101 pieces, at most 1024 with --integration moments");
}

TEST_F(GpuTest, ATableBeyondTheDeviceIsAnError) {
  const TransferBuffer pieces(context(), ramp(), unitSpace());
  IntegrationTables tables(context());
  TableOptions options;
  options.size = {4096, 4096, 4096};
  EXPECT_NE(errorOf(ErrorCode::Device,
                    [&] {
                      tables.build(Integration::Preint3d, options, {pieces, {}});
                    }),
            "no error");
}

TEST(TableSize, IsParsed) {
  EXPECT_EQ(parseTableSize("64"), (std::array<std::uint32_t, 3>{64, 0, 0}));
  EXPECT_EQ(parseTableSize("64x32"), (std::array<std::uint32_t, 3>{64, 32, 0}));
  EXPECT_EQ(parseTableSize("64x32x2"), (std::array<std::uint32_t, 3>{64, 32, 2}));
  for (const char* text : {"", "x", "64x", "1", "64x1", "5000", "2x2x2x2", "2 x2", "-3", "64,32"})
    EXPECT_EQ(errorOf(ErrorCode::Usage, [&] { parseTableSize(text); }),
              std::string("--table-size: found '") + text + "', expected N, NxM or NxMxL with numbers from 2 to 4096");
}

}  // namespace
}  // namespace tetralux::render
