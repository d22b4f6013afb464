#include "volume/lighting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace tetralux {
namespace {

const glm::dvec3 kToEye(0.0, 0.0, 1.0);

TEST(Lighting, HeadLightDependsOnTheAngleToTheEye) {
  const Lighting lighting{.ambient = 0.1, .diffuse = 0.6, .specular = 0.3, .shininess = 5.0};
  const Illumination facing = illuminate(lighting, kToEye, kToEye);
  EXPECT_DOUBLE_EQ(facing.factor.x, 0.7);
  EXPECT_DOUBLE_EQ(facing.highlight.x, 0.3);
  const double angle = 0.4;
  const Illumination tilted = illuminate(lighting, {std::sin(angle), 0.0, std::cos(angle)}, kToEye);
  EXPECT_NEAR(tilted.factor.y, 0.1 + 0.6 * std::cos(angle), 1e-15);
  EXPECT_NEAR(tilted.highlight.y, 0.3 * std::pow(std::cos(2.0 * angle), 5.0), 1e-15);
}

TEST(Lighting, BothSidesAndAllLengthsOfANormalAreAlike) {
  Lighting lighting;
  lighting.lights.push_back({glm::normalize(glm::dvec3(1.0, 2.0, 0.5)), {0.2, 0.5, 1.0}});
  const glm::dvec3 normal(0.3, 0.4, 0.2);
  const Illumination a = illuminate(lighting, normal, kToEye);
  const Illumination b = illuminate(lighting, -7.0 * normal, kToEye);
  EXPECT_NEAR(glm::distance(a.factor, b.factor), 0.0, 1e-14);
  EXPECT_NEAR(glm::distance(a.highlight, b.highlight), 0.0, 1e-14);
}

TEST(Lighting, NoNormalFacesTheEye) {
  const Illumination none = illuminate(Lighting{}, glm::dvec3(0.0), kToEye);
  EXPECT_EQ(none.factor, illuminate(Lighting{}, kToEye, kToEye).factor);
}

TEST(Lighting, LightsBehindTheSurfaceGiveNothing) {
  Lighting lighting;
  lighting.headLight = false;
  lighting.lights.push_back({{0.0, 0.0, -1.0}, glm::dvec3(1.0)});
  const Illumination dark = illuminate(lighting, kToEye, kToEye);
  EXPECT_EQ(dark.factor, glm::dvec3(lighting.ambient));
  EXPECT_EQ(dark.highlight, glm::dvec3(0.0));
}

}  // namespace
}  // namespace tetralux
