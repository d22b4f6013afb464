#include "reference/piece_count.h"

#include <gtest/gtest.h>

#include "mesh/grid.h"
#include "reference/ray_caster.h"

namespace tetralux::reference {
namespace {

// Control points at 0.2, 0.4 and 0.6, the middle one a step.
const TransferFunction& sampleTransfer() {
  static const TransferFunction transfer(
      {{0.2, {1, 0, 0}, 1.0}, {0.4, {0, 1, 0}, 2.0}, {0.4, {0, 0, 1}, 3.0}, {0.6, {1, 1, 1}, 4.0}}, "test");
  return transfer;
}

TEST(PieceCount, IsOneMoreThanTheControlPointsInside) {
  EXPECT_EQ(pieceCount(sampleTransfer(), 0.0, 0.1), 1u);
  EXPECT_EQ(pieceCount(sampleTransfer(), 0.3, 0.3), 1u);
  EXPECT_EQ(pieceCount(sampleTransfer(), 0.1, 0.3), 2u);
  EXPECT_EQ(pieceCount(sampleTransfer(), 0.3, 0.5), 2u);  // the step counts once
  EXPECT_EQ(pieceCount(sampleTransfer(), 0.0, 1.0), 4u);
  EXPECT_EQ(pieceCount(sampleTransfer(), 1.0, 0.0), 4u);
}

TEST(PieceCount, EndsOnControlPointsCutNothing) {
  EXPECT_EQ(pieceCount(sampleTransfer(), 0.2, 0.4), 1u);
  EXPECT_EQ(pieceCount(sampleTransfer(), 0.4, 0.6), 1u);
  EXPECT_EQ(pieceCount(sampleTransfer(), 0.2, 0.6), 2u);
  EXPECT_EQ(pieceCount(sampleTransfer(), 0.4, 0.4), 1u);
}

// The scalar is the depth: cells of one box each, cut by planes across the view.
TEST(PieceCount, OfAMeshAndItsRays) {
  const TetMesh mesh = kuhnGrid(1, 1, 1, {0, 0, 0}, {1, 1, 1}, [](const glm::dvec3& p) { return p.y; });
  const ScalarField field = scalarField(mesh, "", "test");
  // Every one of the six cells reaches from y = 0 to y = 1.
  EXPECT_EQ(cellPieceCount(mesh, field, sampleTransfer()), 6u * 4u);

  Camera camera;
  camera.projection = Projection::Orthographic;
  camera.eye = {0.47, -1.0, 0.52};  // no ray within a face
  camera.center = {0.47, 0.5, 0.52};
  camera.heightWorld = 0.9;
  for (const ReferencePixel& pixel : renderPixels({mesh, field, sampleTransfer(), camera, {7, 7}})) {
    // A ray is cut at its cells' borders and at three control points, which no border meets at a generic pixel.
    EXPECT_GE(pixel.layers, 1u);
    EXPECT_EQ(pixel.pieces, pixel.layers + 3u);
  }
}

}  // namespace
}  // namespace tetralux::reference
