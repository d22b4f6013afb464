#include "render/frame_view.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "mesh/generate.h"

namespace tetralux::render {
namespace {

TetMesh boxAt(const glm::dvec3& low, const glm::dvec3& high) { return kuhnGrid(2, 2, 2, low, high, waveField); }

MeshSpace spaceOf(const TetMesh& mesh) { return makeMeshSpace(mesh, scalarField(mesh, "", "test")); }

TEST(MeshSpace, HoldsTheMeshWithinOneWhateverItsPlaceAndSize) {
  for (const double size : {1e-9, 1.0, 3e9}) {
    for (const double offset : {0.0, 1e6}) {
      const TetMesh mesh = boxAt(glm::dvec3(offset), glm::dvec3(offset + size));
      const MeshSpace space = spaceOf(mesh);
      double largest = 0.0;
      for (size_t i = 0; i < mesh.pointCount(); i++) {
        const glm::dvec3 p = space.position(mesh.point(i));
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      }
      EXPECT_LE(largest, 1.0);
      EXPECT_GT(largest, 0.49);
      EXPECT_EQ(std::exp2(std::round(std::log2(space.scale))), space.scale) << "a power of two";
    }
  }
}

TEST(MeshSpace, ScalarsAreNormalisedBeforeTheyAreRounded) {
  TetMesh mesh = boxAt(glm::dvec3(0), glm::dvec3(1));
  addPreferredField(mesh, "p", [](const glm::dvec3& q) { return 101325.0 + 1e-7 * q.x; });
  const MeshSpace space = spaceOf(mesh);
  EXPECT_NEAR(space.scalar(101325.0), -0.5f, 1e-3);
  EXPECT_NEAR(space.scalar(101325.0 + 1e-7), 0.5f, 1e-3);
  addPreferredField(mesh, "c", [](const glm::dvec3&) { return 7.0; });
  EXPECT_EQ(spaceOf(mesh).scalar(7.0), 0.0f);
}

TEST(FrameSetup, MatrixTakesMeshSpaceToTheScreen) {
  const TetMesh mesh = boxAt({1, 2, 3}, {5, 5, 4});
  const MeshSpace space = spaceOf(mesh);
  const ImageSize size{640, 480};
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    Camera camera;
    camera.projection = projection;
    camera.eye = {9, -7, 6};
    camera.center = {3, 3, 3};
    camera.heightWorld = 5;
    const FrameSetup setup = makeFrameSetup(camera, size, space, 48, 1, 24);
    for (size_t i = 0; i < mesh.pointCount(); i++) {
      const glm::dvec4 clip = camera.clipFromWorld(size) * glm::dvec4(mesh.point(i), 1);
      const glm::vec3 p(space.position(mesh.point(i)));
      glm::vec3 view;
      for (int row = 0; row < 3; row++)
        view[row] = glm::dot(glm::vec3(setup.view.viewFromMesh[row]), p) + setup.view.viewFromMesh[row].w;
      const float divisor = setup.perspective ? view.z : 1.0f;
      EXPECT_NEAR(view.x / divisor * setup.view.pixelsPerUnit / setup.view.halfSize.x, clip.x / clip.w, 1e-5);
      EXPECT_NEAR(view.y / divisor * setup.view.pixelsPerUnit / setup.view.halfSize.y, clip.y / clip.w, 1e-5);
      EXPECT_NEAR(static_cast<double>(view.z) * space.scale, clip.z, 1e-4);
    }
    EXPECT_NEAR(setup.screen.unitsPerPixel * setup.view.pixelsPerUnit, 1.0f, 1e-6);
  }
}

TEST(FrameSetup, NearCellsAreExpectedOnlyWhereTheBoxComesNearTheEyesPlane) {
  const MeshSpace space = spaceOf(boxAt(glm::dvec3(-1), glm::dvec3(1)));
  const auto nearCells = [&](Projection projection, const glm::dvec3& eye) {
    Camera camera;
    camera.projection = projection;
    camera.eye = eye;
    camera.center = eye + glm::dvec3(0, 1, 0);
    return makeFrameSetup(camera, {10, 10}, space, 1, 1, 24).nearCells;
  };
  EXPECT_FALSE(nearCells(Projection::Perspective, {0, -5, 0}));
  EXPECT_TRUE(nearCells(Projection::Perspective, {0, -1.001, 0}));
  EXPECT_TRUE(nearCells(Projection::Perspective, {0, 0, 0}));
  EXPECT_FALSE(nearCells(Projection::Orthographic, {0, -1.01, 0}));
  EXPECT_TRUE(nearCells(Projection::Orthographic, {0, -0.9, 0}));
}

TEST(FrameSetup, KeysCoverTheDistancesOfTheMesh) {
  const TetMesh mesh = randomDelaunay(200, 9);
  const MeshSpace space = spaceOf(mesh);
  for (const glm::dvec3& eye : {glm::dvec3(4, 5, 6), {0.5, 0.4, 0.3}, {1e7, 0, 0}}) {
    Camera camera;
    camera.eye = eye;
    camera.center = glm::dvec3(0.1, 0.2, 0.3);
    const FrameSetup setup = makeFrameSetup(camera, {10, 10}, space, 1, 1, 24);
    const glm::dvec3 e = space.position(eye);
    for (size_t i = 0; i < mesh.pointCount(); i++) {
      const glm::dvec3 p = space.position(mesh.point(i));
      const double relative = glm::dot(p, p - 2.0 * e) / (glm::length(p - e) + glm::length(e));
      const double share =
          (relative - static_cast<double>(setup.view.keyLow)) * static_cast<double>(setup.view.keyPerDistance);
      EXPECT_GE(share, -1e-5);
      EXPECT_LE(share, 1.0 + 1e-5);
    }
  }
}

}  // namespace
}  // namespace tetralux::render
