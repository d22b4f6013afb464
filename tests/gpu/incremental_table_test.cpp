// Tables that are made slice by slice, against those whose every entry is integrated by itself.
#include <gtest/gtest.h>

#include <cmath>

#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"
#include "segments.h"

namespace tetralux::render {
namespace {

using test::GpuTest;

constexpr Integration kMethods[] = {Integration::Preint3d, Integration::Preint3dLog, Integration::Preint3dOctave};

std::vector<glm::vec4> entries(const gpu::Context& context, Integration method, const TransferFunction& transfer,
                               std::array<std::uint32_t, 3> size, TableBuild build,
                               TableFormat format = TableFormat::F32) {
  const TransferBuffer pieces(context, transfer, test::unitSpace());
  IntegrationTables tables(context);
  TableOptions options;
  options.size = size;
  options.format = format;
  options.build = build;
  tables.build(method, options, {pieces, {}});
  EXPECT_EQ(tables.tableBuild(), build);
  return tables.read();
}

// Largest and root mean square difference of the entries' channels.
struct Difference {
  double max = 0.0;
  double rms = 0.0;
};

Difference difference(const gpu::Context& context, Integration method, const TransferFunction& transfer,
                      std::array<std::uint32_t, 3> size, TableFormat format = TableFormat::F32) {
  const auto exact = entries(context, method, transfer, size, TableBuild::Exact);
  const auto incremental = entries(context, method, transfer, size, TableBuild::Incremental, format);
  Difference d;
  for (size_t i = 0; i < exact.size(); i++) {
    for (int c = 0; c < 4; c++) {
      const double error = std::abs(static_cast<double>(exact[i][c]) - static_cast<double>(incremental[i][c]));
      EXPECT_TRUE(std::isfinite(error));
      d.max = std::max(d.max, error);
      d.rms += error * error;
    }
  }
  d.rms = std::sqrt(d.rms / (4.0 * static_cast<double>(exact.size())));
  return d;
}

// Interpolation between equal entries is exact: what is left is the rounding of up to thirty slices, each on top of the
// last.
TEST_F(GpuTest, IncrementalTablesAreExactForAConstantTransferFunction) {
  for (const Emission emission : {Emission::PerExtinction, Emission::PerLength}) {
    const TransferFunction constant({{0, {0.3, 0.6, 0.9}, 2}}, "constant", emission);
    for (const Integration method : kMethods)
      EXPECT_LE(difference(context(), method, constant, {9, 7, 32}).max, 5e-6) << integrationName(method);
  }
}

// An optical depth of 8 along the thickest segments. Thirty steps of one slice each add up to more than as many
// doublings.
TEST_F(GpuTest, IncrementalTablesAreNearlyExactForALinearTransferFunction) {
  for (const Emission emission : {Emission::PerExtinction, Emission::PerLength}) {
    const TransferFunction ramp({{0, {1, 0, 0.5}, 0}, {1, {0, 1, 0.5}, 8}}, "ramp", emission);
    for (const Integration method : kMethods) {
      const Difference d = difference(context(), method, ramp, {128, 128, 32});
      EXPECT_LE(d.max, method == Integration::Preint3d ? 2e-3 : 4e-4) << integrationName(method);
      EXPECT_LE(d.rms, method == Integration::Preint3d ? 1e-4 : 2e-5) << integrationName(method);
    }
  }
}

// Interpolation is of second order in the distance of the scalars, and of first at the transfer function's kinks, which
// are few: the largest difference nearly halves, the mean one falls to less than 0.4 when the distance is halved.
TEST_F(GpuTest, IncrementalTablesConvergeToTheExactOnes) {
  for (const Emission emission : {Emission::PerExtinction, Emission::PerLength}) {
    const TransferFunction bands(test::orderTransfer().points(), "bands", emission);
    for (const Integration method : kMethods) {
      double last = 1.0;
      for (const std::uint32_t size : {33u, 65u, 129u, 257u}) {
        const Difference d = difference(context(), method, bands, {size, size, 16});
        EXPECT_LE(d.rms, 0.4 * last) << integrationName(method) << " " << size;
        EXPECT_LE(d.max, 1.5 * 0.0106 * 256.0 / (size - 1)) << integrationName(method) << " " << size;
        last = d.rms;
      }
      EXPECT_LE(last, method == Integration::Preint3d ? 1.5e-4 : 4e-5) << integrationName(method);
    }
  }
}

// Sides that differ, and formats, which are packed from the same entries.
TEST_F(GpuTest, IncrementalTablesAreStoredInEveryFormat) {
  const TransferFunction transfer({{0, {3, 0, 0.5}, 0}, {0.43, {0, 1, 0.5}, 9}, {1, {0.5, 0, 1}, 1}}, "t");
  for (const Integration method : kMethods) {
    const auto floats = entries(context(), method, transfer, {17, 11, 9}, TableBuild::Incremental);
    const std::pair<TableFormat, float> steps[] = {{TableFormat::Unorm8, 3 * 0.51f / 255},
                                                   {TableFormat::Unorm16, 3 * 0.51f / 65535},
                                                   {TableFormat::F16, 3.03f / 2048}};
    for (const auto& [format, step] : steps) {
      const auto packed = entries(context(), method, transfer, {17, 11, 9}, TableBuild::Incremental, format);
      ASSERT_EQ(packed.size(), floats.size());
      for (size_t i = 0; i < packed.size(); i++) {
        for (int c = 0; c < 4; c++)
          ASSERT_NEAR(packed[i][c], floats[i][c], step) << tableFormatName(format) << " " << i;
      }
    }
  }
  // Two slices, the fewest, are the exact ones.
  EXPECT_EQ(difference(context(), Integration::Preint3dLog, transfer, {17, 17, 2}).max, 0.0);
}

TEST_F(GpuTest, FramesTellHowTheirTableWasMade) {
  const TetMesh mesh = randomDelaunay(100, 2);
  Renderer renderer(context(), mesh, scalarField(mesh, "", "test"));
  renderer.setTransferFunction(test::orderTransfer());
  const Camera camera = test::orderViews(mesh)[0];
  RenderOptions options;
  options.table.size = {32, 32, 8};
  const auto build = [&](Integration method, TableBuild tableBuild) {
    options.integration = method;
    options.table.build = tableBuild;
    return renderer.draw(camera, {32, 24}, options).tableBuild;
  };
  EXPECT_EQ(build(Integration::Preint3d, TableBuild::Exact), TableBuild::Exact);
  EXPECT_EQ(build(Integration::Preint3d, TableBuild::Incremental), TableBuild::Incremental);
  EXPECT_EQ(build(Integration::Preint2d, TableBuild::Incremental), std::nullopt);
  EXPECT_EQ(build(Integration::Exact, TableBuild::Incremental), std::nullopt);
}

}  // namespace
}  // namespace tetralux::render
