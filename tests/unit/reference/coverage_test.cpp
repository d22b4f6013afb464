#include "reference/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "painted_box.h"
#include "reference/cell_shows.h"

namespace tetralux::reference {
namespace {

constexpr ImageSize kSize{40, 30};

PaintedBox waveBox() {
  PaintedBox box(jitteredGrid(4, 4, 4, glm::dvec3(0.0), glm::dvec3(1.0), 0.1, 1, waveField));
  box.transfer = TransferFunction({{0.0, {0.2, 0.4, 0.8}, 0.5}, {1.0, {0.9, 0.3, 0.1}, 3.0}}, "test");
  box.camera.eye = {2.5, -2.0, 1.7};
  box.camera.center = {0.5, 0.5, 0.5};
  box.camera.fovyDegrees = 40.0;
  return box;
}

Isosurface surfaceOf(double value, double opacity) {
  Isosurface surface;
  surface.value = value;
  surface.opacity = opacity;
  surface.shading = Shading::None;
  return surface;
}

// Every pixel that the reference shows is covered, told from an empty picture alone. Returns how many of the covered
// pixels are empty.
int expectCovered(const PaintedBox& box) {
  const auto pixels = box.render(kSize);
  const auto covered = coveredPixels(box.scene(kSize), Image(kSize.width, kSize.height));
  int empty = 0;
  int shown = 0;
  for (size_t i = 0; i < covered.size(); i++) {
    const bool isShown = pixels[i].alpha > 0.0 || pixels[i].light != glm::dvec3(0.0);
    EXPECT_TRUE(!isShown || covered[i] != 0) << i;
    empty += covered[i] != 0 && !isShown ? 1 : 0;
    shown += isShown ? 1 : 0;
  }
  EXPECT_GT(shown, 20);
  return empty;
}

TEST(Coverage, OfIsosurfacesIsWhereRaysCrossThem) {
  PaintedBox box = waveBox();
  box.appearance.volumeVisible = false;
  box.appearance.isosurfaces = {surfaceOf(0.3, 0.5), surfaceOf(0.7, 1.0), surfaceOf(0.9, 0.0)};
  EXPECT_EQ(expectCovered(box), 0);
  box.appearance.isosurfaces = {surfaceOf(0.75, 1.0)};
  EXPECT_EQ(expectCovered(box), 0);
  box.appearance.clip = {{{-1, 0, 0}, -0.5}};
  EXPECT_EQ(expectCovered(box), 0);
}

TEST(Coverage, OfAClippedVolumeIsWhatIsLeft) {
  PaintedBox box = waveBox();
  box.appearance.clip = {{{1, 1, 0}, 1.3}};
  EXPECT_EQ(expectCovered(box), 0);
}

TEST(Coverage, OfSurfacesIsWhereRaysMeetThem) {
  PaintedBox box = waveBox();
  box.transfer = TransferFunction();
  OpaqueSurface triangle;
  triangle.points = {{0, 0, 0.5}, {1.2, 0, 0.5}, {0, 1.4, 0.9}};
  triangle.triangles = {{0, 1, 2}};
  box.data.surfaces = {triangle};
  EXPECT_EQ(expectCovered(box), 0);
}

// A volume without a transfer function of its own, or of a factor that is zero in half the box.
TEST(Coverage, OfClassifiedVolumesLeavesOutWhatCannotShow) {
  PaintedBox box = waveBox();
  box.data.modulators.resize(1);
  for (size_t i = 0; i < box.mesh.pointCount(); i++) {
    const double x = box.mesh.point(i).x;
    box.data.modulators[0].push_back(x);
    box.data.gradientMagnitudes.push_back(x);
    box.data.rgba.push_back({1, 1, 1, std::max(0.0, x - 0.6)});
  }
  const auto cellsThatMayShow = [&] {
    const ReferenceScene scene = box.scene(kSize);
    size_t count = 0;
    for (size_t cell = 0; cell < box.mesh.cellCount(); cell++) {
      const bool mayShow = cellMayShow(scene, cell);
      count += mayShow ? 1 : 0;
      if (mayShow) continue;
      // Beyond doubt: all of it lies where nothing absorbs.
      for (const std::uint32_t vertex : box.mesh.cells[cell]) EXPECT_LE(box.mesh.point(vertex).x, 0.6);
    }
    return count;
  };
  Modulation modulation;
  modulation.by = ModulatedBy::Field;
  modulation.curve = FactorCurve({{0.6, 0, {1, 1, 1}}, {0.6, 1, {1, 1, 1}}}, "step");
  box.appearance.modulations = {modulation};
  EXPECT_LT(cellsThatMayShow(), box.mesh.cellCount());
  expectCovered(box);
  box.appearance.modulations.clear();
  box.data.modulators.clear();
  box.appearance.transfer2d =
      TransferFunction2d({0, 1}, {0.6, 0.7}, {{{1, 1, 1}, 0}, {{1, 1, 1}, 0}, {{1, 1, 1}, 1}, {{1, 1, 1}, 2}}, "grid");
  EXPECT_LT(cellsThatMayShow(), box.mesh.cellCount());
  expectCovered(box);
  box.appearance.transfer2d.reset();
  box.appearance.rgbaField = RgbaField{"rgb", "tau"};
  EXPECT_LT(cellsThatMayShow(), box.mesh.cellCount());
  expectCovered(box);
}

}  // namespace
}  // namespace tetralux::reference
