#include "reference/ray_caster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/generate.h"
#include "reference/segment_integral.h"

namespace tetralux::reference {
namespace {

const TransferFunction& uniform() {
  static const TransferFunction transfer({{0, {0.5, 1, 0.25}, 1.5}}, "uniform");
  return transfer;
}

// Length of a ray inside the box [0, 1]^3, in front of its origin.
double chord(const Ray& ray) {
  double front = 0.0;
  double back = 1e300;
  for (int axis = 0; axis < 3; axis++) {
    const double a = (0.0 - ray.origin[axis]) / ray.direction[axis];
    const double b = (1.0 - ray.origin[axis]) / ray.direction[axis];
    front = std::max(front, std::min(a, b));
    back = std::min(back, std::max(a, b));
  }
  return std::max(0.0, back - front) * ray.lengthPerDepth;
}

std::vector<Camera> cameras() {
  std::vector<Camera> result(4);
  result[0].eye = {2.1, -1.7, 1.3};  // outside
  result[1].eye = {0.4, 0.3, 0.6};   // inside
  result[2].eye = {2.1, -1.7, 1.3};
  result[2].projection = Projection::Orthographic;
  result[2].heightWorld = 2.2;
  result[3].eye = {0.7, 0.2, 0.5};  // the eye's plane cuts the box
  result[3].projection = Projection::Orthographic;
  result[3].heightWorld = 1.5;
  for (Camera& camera : result) {
    camera.center = {0.52, 0.47, 0.51};
    camera.fovyDegrees = 50;
  }
  return result;
}

// Closed form: a uniform box gives c (1 - exp(-tau d)), d the chord of the pixel's ray, from any view.
TEST(RayCaster, UniformBoxIsTheClosedFormFromAnyView) {
  const TetMesh mesh = jitteredGrid(3, 4, 2, glm::dvec3(0), glm::dvec3(1), 0.1, 5, waveField);
  const ScalarField field = scalarField(mesh, "", "test");
  const ImageSize size{37, 29};
  for (const Camera& camera : cameras()) {
    const auto pixels = renderPixels({mesh, field, uniform(), camera, size});
    for (std::uint32_t y = 0; y < size.height; y++) {
      for (std::uint32_t x = 0; x < size.width; x++) {
        const ReferencePixel& p = pixels[y * size.width + x];
        const double alpha = 1.0 - std::exp(-1.5 * chord(camera.pixelRay(size, x, y)));
        EXPECT_NEAR(p.alpha, alpha, 1e-12);
        EXPECT_NEAR(p.light.x, 0.5 * alpha, 1e-12);
        EXPECT_EQ(p.layers > 0, alpha > 0) << x << " " << y;
      }
    }
  }
}

TEST(RayCaster, ChosenPixelsAreThoseOfTheWholeImage) {
  const TetMesh mesh = randomDelaunay(300, 3);
  const ScalarField field = scalarField(mesh, "", "test");
  const TransferFunction transfer({{0, {1, 0, 0}, 0}, {0.5, {0, 1, 0}, 3}, {1, {0, 0, 1}, 9}}, "t");
  const ImageSize size{50, 40};
  const Camera camera = cameras()[0];
  const auto whole = renderPixels({mesh, field, transfer, camera, size});
  const std::vector<PixelPosition> positions = {{49, 39}, {0, 0}, {25, 20}, {25, 20}, {24, 20}, {17, 16}, {16, 15}};
  const auto some = renderPixels({mesh, field, transfer, camera, size}, positions);
  ASSERT_EQ(some.size(), positions.size());
  for (size_t i = 0; i < positions.size(); i++) {
    EXPECT_EQ(some[i].light, whole[positions[i].y * size.width + positions[i].x].light);
    EXPECT_EQ(some[i].layers, whole[positions[i].y * size.width + positions[i].x].layers);
  }
}

TEST(RayCaster, NearerCellsHideFartherOnes) {
  TetMesh mesh;
  const auto box = [&](double y) {
    const auto first = static_cast<std::uint32_t>(mesh.pointCount());
    auto& points = std::get<std::vector<glm::dvec3>>(mesh.points);
    for (const glm::dvec3& p : {glm::dvec3(-9, y, -9), {9, y, -9}, {0, y, 9}, {0, y + 0.5, 0}}) points.push_back(p);
    mesh.cells.push_back({first, first + 1, first + 2, first + 3});
  };
  mesh.points = std::vector<glm::dvec3>{};
  box(5);  // far, first in the file
  box(1);
  mesh.pointArrays.push_back({"s", 1, std::vector<float>{0, 0, 0, 0, 1, 1, 1, 1}});
  const TransferFunction transfer({{0, {1, 0, 0}, 1000}, {1, {0, 1, 0}, 1000}}, "t");
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.center = {0, 1, 0};
  const auto p = renderPixels({mesh, scalarField(mesh, "s", "t"), transfer, camera, {1, 1}})[0];
  EXPECT_NEAR(p.light.y, 1.0, 1e-12);
  EXPECT_NEAR(p.light.x, 0.0, 1e-12);
  EXPECT_EQ(p.layers, 2u);
}

TEST(RayCaster, OverlappingCellsBothContributeAndFlatOnesDoNot) {
  TetMesh mesh;
  mesh.points = std::vector<glm::dvec3>{{-1, 1, -1}, {1, 1, -1}, {0, 1, 1}, {0, 2, 0}, {0, 1, 0}};
  mesh.cells = {{0, 1, 2, 3}, {1, 0, 2, 3}, {0, 1, 2, 4}, {0, 0, 1, 2}};  // a copy turned inside out, two flat ones
  mesh.pointArrays.push_back({"s", 1, std::vector<float>(5, 0.0f)});
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.center = {0, 1, 0};
  const auto p = renderPixels({mesh, scalarField(mesh, "s", "t"), uniform(), camera, {1, 1}})[0];
  EXPECT_EQ(p.layers, 2u);
  EXPECT_NEAR(p.alpha, 1.0 - std::exp(-2 * 1.5 * 1.0), 1e-12);
}

TEST(RayCaster, CellFieldsAreConstantInEachCell) {
  TetMesh mesh = kuhnGrid(1, 1, 1, glm::dvec3(0), glm::dvec3(1), waveField);
  mesh.cellArrays.push_back({"c", 1, std::vector<float>(6, 2.0f)});
  const TransferFunction transfer({{0, {1, 1, 1}, 0}, {4, {1, 1, 1}, 3}}, "t");
  const Camera camera = cameras()[0];
  const ImageSize size{8, 8};
  const auto pixels = renderPixels({mesh, scalarField(mesh, "c", "t"), transfer, camera, size});
  for (std::uint32_t i = 0; i < 64; i++)
    EXPECT_NEAR(pixels[i].alpha, 1.0 - std::exp(-1.5 * chord(camera.pixelRay(size, i % 8, i / 8))), 1e-12);
}

TEST(RayCaster, SplittingCellsLeavesThePictureUnchanged) {
  // A linear field is the same function on any mesh of the box.
  const auto linear = [](const glm::dvec3& p) { return 0.3 * p.x + 0.5 * p.y + 0.2 * p.z; };
  const TransferFunction transfer({{0.1, {1, 0, 0}, 1}, {0.5, {0, 1, 0}, 5}, {0.8, {0, 0, 1}, 2}}, "t");
  const TetMesh coarse = kuhnGrid(1, 1, 1, glm::dvec3(0), glm::dvec3(1), linear);
  TetMesh fine = randomDelaunay(2000, 4, linear);
  const ImageSize size{24, 24};
  for (const Camera& camera : cameras()) {
    const auto a = renderPixels({coarse, scalarField(coarse, "", "t"), transfer, camera, size});
    const auto b = renderPixels({fine, scalarField(fine, "", "t"), transfer, camera, size});
    for (size_t i = 0; i < a.size(); i++) {
      EXPECT_NEAR(a[i].alpha, b[i].alpha, 1e-9);
      for (int c = 0; c < 3; c++) EXPECT_NEAR(a[i].light[c], b[i].light[c], 1e-9);
    }
  }
}

}  // namespace
}  // namespace tetralux::reference
