// Which measurements a chart consists of.
#include "cli/chart_plan.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "render/order/cell_order.h"

namespace tetralux::cli {
namespace {

using ::testing::IsSupersetOf;

PlanOptions wholePlan() {
  PlanOptions options;
  options.scenes = {"a/one.json", "two.vtu", "b/one.json"};
  options.cells = {1000, 10000};
  return options;
}

// Values of a key over all pictures of a scene.
std::set<std::string> picturedValues(const ChartPlan& plan, size_t scene, const std::string& key) {
  std::set<std::string> values;
  for (const Measurement& m : plan.measurements) {
    if (m.scene == scene && m.kind == MeasurementKind::Picture) values.insert(m.configuration.value(key));
  }
  return values;
}

TEST(ChartPlan, EveryWayOfDrawingIsInIt) {
  const ChartPlan plan = makeChartPlan(wholePlan());
  for (size_t scene = 0; scene < 3; scene++) {
    EXPECT_THAT(picturedValues(plan, scene, "integration"), IsSupersetOf(render::integrationNames()));
    EXPECT_THAT(picturedValues(plan, scene, "projection"), IsSupersetOf(render::projectionNames()));
    EXPECT_THAT(picturedValues(plan, scene, "tolerance"), IsSupersetOf({"1/32", "1/4096"}));
    EXPECT_THAT(picturedValues(plan, scene, "interpolation"), IsSupersetOf(render::interpolationNames()));
    EXPECT_THAT(picturedValues(plan, scene, "target"), IsSupersetOf(render::targetNames()));
    EXPECT_THAT(picturedValues(plan, scene, "order"), IsSupersetOf({"auto", "radix", "exact"}));
  }
}

TEST(ChartPlan, EveryMethodWithATableHasItsSizes) {
  PlanOptions options = wholePlan();
  options.sets = {"tables"};
  std::map<std::string, int> sizes;
  for (const Measurement& m : makeChartPlan(options).measurements) {
    EXPECT_EQ(m.kind, MeasurementKind::Error);
    if (m.scene == 0) sizes[m.configuration.value("integration")]++;
  }
  for (const std::string& method : render::integrationNames()) {
    const bool hasTable = render::tableDimensions(render::parseIntegration(method)) > 0;
    EXPECT_EQ(sizes[method] >= 5, hasTable) << method;
  }
}

TEST(ChartPlan, NothingIsMeasuredTwice) {
  std::set<std::string> seen;
  for (const Measurement& m : makeChartPlan(wholePlan()).measurements) {
    const std::string text =
        fmt::format("{} {} {} {}", measurementKindName(m.kind), m.scene, m.configuration.text(), m.side);
    EXPECT_TRUE(seen.insert(text).second) << text;
  }
}

TEST(ChartPlan, NamesAreUnique) {
  const ChartPlan plan = makeChartPlan(wholePlan());
  std::vector<std::string> names;
  for (const ChartScene& scene : plan.scenes) names.push_back(scene.name);
  EXPECT_EQ(names, (std::vector<std::string>{"one", "two", "one-2", "generated-1000", "generated-10000"}));
}

TEST(ChartPlan, AConfigurationTakesThePlaceOfTheList) {
  PlanOptions options = wholePlan();
  options.configurations = {"integration=ppi,table-size=64", "projection=march", "projection=march"};
  const ChartPlan plan = makeChartPlan(options);
  EXPECT_EQ(plan.measurements.size(), 3u * (1 + 2));
  EXPECT_EQ(plan.scenes.size(), 3u);
}

TEST(Configuration, TextIsRead) {
  const Configuration configuration = Configuration::parse("target=rgba8,integration=ppi,table-size=128x64,k=3");
  EXPECT_EQ(Configuration::parse("k=3,table-size=128x64,target=rgba8,integration=ppi"), configuration);
  const DeviceOptions options = configuration.deviceOptions();
  EXPECT_EQ(options.integration, "ppi");
  EXPECT_EQ(options.tableSize, "128x64");
  EXPECT_EQ(options.kBuffer, 3u);
  EXPECT_EQ(options.target, "rgba8");
  EXPECT_EQ(options.projection, "pt");
  EXPECT_EQ(configuration.name(), "ppi 128x64 k=3 rgba8");
  EXPECT_EQ(Configuration().name(), "default");
  EXPECT_EQ(Configuration::parse("target=auto").name(), "target auto");
}

}  // namespace
}  // namespace tetralux::cli
