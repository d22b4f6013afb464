#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "render/transfer_buffer.h"
#include "shared/limits.h"

namespace tetralux::render {
namespace {

MeshSpace space(double low, double high, double scale = 1.0) {
  MeshSpace s;
  s.scalarCenter = 0.5 * (low + high);
  s.scalarRange = high - low;
  s.scale = scale;
  return s;
}

TEST(TransferTables, PiecesAreTheTransferFunctionInTheDevicesUnits) {
  const TransferFunction transfer({{10, {1, 0, 0}, 2}, {14, {0, 1, 0}, 6}, {30, {0, 0, 1}, 0}}, "t");
  const TransferTables tables = makeTransferTables(transfer, space(10, 30, 4.0));
  ASSERT_EQ(tables.pieces.size(), 4u * shared::TRANSFER_PIECE_TEXELS);
  const glm::vec4 second = tables.pieces[shared::TRANSFER_PIECE_TEXELS];
  EXPECT_FLOAT_EQ(second.x, -0.5f);
  EXPECT_FLOAT_EQ(second.y, -0.3f);
  EXPECT_FLOAT_EQ(second.z, 8.0f);          // 2 per world unit, 4 world units per mesh unit
  EXPECT_FLOAT_EQ(second.w, 16.0f / 0.2f);  // slope
  EXPECT_EQ(tables.pieces.front().z, 8.0f);
  EXPECT_EQ(tables.pieces.front().w, 0.0f);
}

TEST(TransferTables, PointsAreTheEndsOfAllPiecesOnceEach) {
  const TransferFunction transfer({{0, {1, 0, 0}, 1}, {0.5, {0, 1, 0}, 2}, {0.5, {0, 0, 1}, 7}, {1, {}, 9}}, "t");
  const TransferTables tables = makeTransferTables(transfer, space(0, 1));
  const std::vector<glm::vec2> expected = {{-1e30f, -0.5f}, {-0.5f, 0.0f}, {0.0f, 0.0f}, {0.0f, 0.5f}, {0.5f, 1e30f}};
  EXPECT_EQ(tables.pointScalars, expected);
  ASSERT_EQ(tables.points.size(), expected.size() + 1);
  EXPECT_EQ(tables.points[0], tables.points[1]);
  EXPECT_EQ(tables.points[2], glm::vec4(0, 1, 0, 2));  // below the step
  EXPECT_EQ(tables.points[3], glm::vec4(0, 0, 1, 7));  // above it
  EXPECT_EQ(tables.points[5], glm::vec4(0, 0, 0, 9));
}

TEST(TransferTables, BinsNameThePieceAtTheirEnds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-0.2, 1.2);
  std::vector<ControlPoint> points;
  for (int i = 0; i < 40; i++) points.push_back({uniform(random), {}, 1});
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.s < b.s; });
  const TransferTables tables = makeTransferTables(TransferFunction(points, "t"), space(0, 1));
  const auto holds = [&](std::uint32_t piece, float s) {
    const glm::vec4 range = tables.pieces.at(piece * shared::TRANSFER_PIECE_TEXELS);
    return range.x <= s && s < range.y;
  };
  for (std::uint32_t bin = 0; bin < shared::TRANSFER_BINS; bin++) {
    const float low = static_cast<float>(bin) / shared::TRANSFER_BINS - 0.5f;
    const float high = static_cast<float>(bin + 1) / shared::TRANSFER_BINS - 0.5f;
    EXPECT_TRUE(holds(tables.pieceBins[2 * bin], std::nextafter(low, -1.0f))) << bin;
    EXPECT_TRUE(holds(tables.pieceBins[2 * bin + 1], std::nextafter(high, 1.0f))) << bin;
  }
}

TEST(TransferTables, StepsAndPiecesTooNarrowForFloatsHaveNoWidth) {
  const TransferFunction transfer({{0, {}, 1}, {0.5, {}, 1}, {0.5, {}, 7}, {0.5 + 1e-12, {}, 9}, {1, {}, 9}}, "t");
  const TransferTables tables = makeTransferTables(transfer, space(0, 1));
  for (size_t i = 0; i < tables.pieces.size(); i += shared::TRANSFER_PIECE_TEXELS) {
    EXPECT_LT(tables.pieces[i].x, tables.pieces[i].y);
    EXPECT_TRUE(std::isfinite(tables.pieces[i].w));
  }
}

// The shader takes two entries that cover a range of bins between them.
TEST(TransferTables, LargestExtinctionBoundsEveryRange) {
  const TransferFunction transfer({{0.1, {}, 0}, {0.2, {}, 5}, {0.201, {}, 900}, {0.202, {}, 1}, {0.9, {}, 3}}, "t");
  const TransferTables tables = makeTransferTables(transfer, space(0, 1, 2.0));
  ASSERT_EQ(tables.largestExtinction.size(), std::size_t{shared::EXTINCTION_LEVELS} * shared::TRANSFER_BINS);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 2000; i++) {
    const double a = uniform(random);
    const double b = uniform(random) < 0.5 ? a + 0.01 * uniform(random) : uniform(random);
    const auto bin = [](double s) { return static_cast<std::uint32_t>(std::clamp(s * 256.0, 0.0, 255.0)); };
    const std::uint32_t first = bin(std::min(a, b));
    const std::uint32_t last = bin(std::max(a, b));
    const auto level = static_cast<std::uint32_t>(std::bit_width(last - first + 1) - 1);
    const float* row = tables.largestExtinction.data() + level * shared::TRANSFER_BINS;
    const double bound = static_cast<double>(std::max(row[first], row[last + 1 - (1u << level)]));
    for (int k = 0; k <= 20; k++) EXPECT_LE(transfer.at(a + (b - a) * k / 20.0).extinction * 2.0, bound * (1 + 1e-6));
    EXPECT_LE(bound, 1800.0 * (1 + 1e-6));
  }
}

TEST(TransferTables, SupportIsWhereThereIsExtinction) {
  const TransferFunction peaks(
      {{0, {}, 0}, {0.2, {}, 0}, {0.3, {}, 5}, {0.4, {}, 0}, {0.6, {}, 0}, {0.6, {}, 2}, {0.8, {}, 2}, {0.8, {}, 0}},
      "t");
  const auto support = makeTransferTables(peaks, space(0, 1)).support;
  ASSERT_EQ(support.size(), 2u);
  EXPECT_FLOAT_EQ(support[0].x, -0.3f);
  EXPECT_FLOAT_EQ(support[0].y, -0.1f);
  EXPECT_LT(support[1].x, 0.1f) << "a scalar exactly on the step up has extinction";
  EXPECT_FLOAT_EQ(support[1].y, 0.3f);
  EXPECT_TRUE(makeTransferTables(TransferFunction({{0, {}, 0}}, "t"), space(0, 1)).support.empty());
}

TEST(TransferTables, EmissionPerLengthShowsWithoutExtinction) {
  const std::vector<ControlPoint> points = {{0, {}, 0},    {0.25, {}, 0},        {0.5, {0, 8, 0}, 0}, {0.5, {}, 0},
                                            {0.75, {}, 0}, {0.75, {0, 0, 1}, 0}, {1, {0, 0, 1}, 0}};
  EXPECT_TRUE(makeTransferTables(TransferFunction(points, "t"), space(0, 1)).support.empty());
  const TransferTables tables =
      makeTransferTables(TransferFunction(points, "t", Emission::PerLength), space(0, 1, 4.0));
  ASSERT_EQ(tables.support.size(), 2u);
  EXPECT_FLOAT_EQ(tables.support[0].x, -0.25f);
  EXPECT_FLOAT_EQ(tables.support[0].y, 0.0f);
  EXPECT_LT(tables.support[1].x, 0.25f) << "a scalar exactly on the step up emits";
  EXPECT_GT(tables.support[1].y, 0.5f);
  EXPECT_FLOAT_EQ(tables.pieces[2 * shared::TRANSFER_PIECE_TEXELS + 2].y, 32.0f / 0.25f) << "slope, per mesh unit";
  EXPECT_NEAR(*std::max_element(tables.largestExtinction.begin(), tables.largestExtinction.end()), 32.0f, 1e-3f);
}

TEST(TransferTables, ControlPointsFarOutsideTheFieldStayFinite) {
  const TransferFunction transfer({{-1e300, {}, 1}, {1e300, {}, 2}}, "t");
  for (const glm::vec4& texel : makeTransferTables(transfer, space(0, 1e-12)).pieces) {
    for (int i = 0; i < 4; i++) EXPECT_TRUE(std::isfinite(texel[i]));
  }
}

}  // namespace
}  // namespace tetralux::render
