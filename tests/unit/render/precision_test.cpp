// Where rays need double precision, and what single leaves for it.
#include "render/precision.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/two_floats.h"
#include "mesh/generate.h"
#include "render/mesh_space.h"

namespace tetralux::render {
namespace {

TEST(Precision, DenseMediaAndSmallTolerancesNeedDouble) {
  EXPECT_FALSE(isTooDenseForSingle(10.0, {}));
  EXPECT_TRUE(isTooDenseForSingle(1e6, {}));
  EXPECT_FALSE(isTooDenseForSingle(200.0, 1.0 / 510.0));
  EXPECT_TRUE(isTooDenseForSingle(200.0, 1.0 / 4096.0));
}

TEST(Precision, FinePixelsNeedDouble) {
  EXPECT_FALSE(isTooFineForSingle(2.0 / 1024.0));  // the whole mesh in a picture
  EXPECT_TRUE(isTooFineForSingle(1e-6));
}

TEST(Precision, TwoFloatsHoldFortyEightBits) {
  for (const double value : {1.0 / 3.0, -0.41999995999999995, 1e-7 / 3.0, 12345.678901234567}) {
    const double sum = static_cast<double>(static_cast<float>(value)) + static_cast<double>(restOfFloat(value));
    EXPECT_NEAR(sum, value, std::abs(value) * std::exp2(-48.0)) << value;
  }
  EXPECT_EQ(restOfFloat(0.5), 0.0f);
}

TEST(Precision, PositionsAreTheirRoundedPartAndTheRest) {
  const TetMesh mesh = kuhnGrid(3, 3, 3, glm::dvec3(0.1), glm::dvec3(0.7, 1.3, 2.9), waveField);
  const MeshSpace space = makeMeshSpace(mesh, scalarField(mesh, "", "test"));
  bool isInexact = false;
  for (size_t i = 0; i < mesh.pointCount(); i++) {
    const glm::dvec3 exact = space.position(mesh.point(i));
    const glm::dvec3 rest(space.positionRest(mesh.point(i)));
    const glm::dvec3 error = glm::dvec3(space.roundedPosition(mesh.point(i))) + rest - exact;
    for (int axis = 0; axis < 3; axis++) EXPECT_LE(std::abs(error[axis]), std::exp2(-48.0));
    isInexact = isInexact || rest != glm::dvec3(0.0);
  }
  EXPECT_TRUE(isInexact);
}

}  // namespace
}  // namespace tetralux::render
