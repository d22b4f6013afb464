#include "view/camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "support/expect_error.h"

namespace tetralux {
namespace {

using test::errorOf;
using ::testing::HasSubstr;

constexpr double kTolerance = 1e-13;

Camera perspective() {
  Camera camera;
  camera.eye = {10, -20, 7};
  camera.center = {1, 2, 3};
  camera.up = {0, 0.1, 5};
  camera.fovyDegrees = 40;
  return camera;
}

Camera orthographic() {
  Camera camera = perspective();
  camera.projection = Projection::Orthographic;
  camera.heightWorld = 6;
  return camera;
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
  for (int i = 0; i < 3; i++) EXPECT_NEAR(a[i], b[i], kTolerance);
}

TEST(Camera, ViewSpaceIsRightUpForwardWithTheEyeAtZero) {
  const Camera camera = perspective();
  const glm::dmat4 view = camera.viewFromWorld();
  expectNear(view * glm::dvec4(camera.eye, 1), glm::dvec3(0));
  const double distance = glm::length(camera.center - camera.eye);
  expectNear(view * glm::dvec4(camera.center, 1), glm::dvec3(0, 0, distance));
  const glm::dvec3 up = camera.viewRotation() * camera.up;
  EXPECT_NEAR(up.x, 0.0, kTolerance);
  EXPECT_GT(up.y, 0.0);
  // x to the right: for a viewer looking along +y with z up, that is +x.
  Camera simple;
  simple.eye = {0, -1, 0};
  simple.center = {0, 0, 0};
  simple.up = {0, 0, 1};
  expectNear(simple.viewRotation() * glm::dvec3(1, 0, 0), glm::dvec3(1, 0, 0));
  expectNear(simple.viewRotation() * glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0));
}

// The contract: pixel (i, j) sees ndc x = 2 (i + 0.5)/w - 1, y = 1 - 2 (j + 0.5)/h.
TEST(Camera, PixelRaysPassThroughTheirNdc) {
  const ImageSize size{64, 40};
  for (const Camera& camera : {perspective(), orthographic()}) {
    const glm::dmat4 clipFromWorld = camera.clipFromWorld(size);
    for (const auto& [i, j] : {std::pair(0, 0), std::pair(63, 39), std::pair(17, 30), std::pair(32, 20)}) {
      const Ray ray = camera.pixelRay(size, i, j);
      for (const double depth : {0.5, 3.0, 100.0}) {
        const glm::dvec4 clip = clipFromWorld * glm::dvec4(ray.origin + depth * ray.direction, 1);
        EXPECT_NEAR(clip.x / clip.w, 2 * (i + 0.5) / size.width - 1, 1e-12);
        EXPECT_NEAR(clip.y / clip.w, 1 - 2 * (j + 0.5) / size.height, 1e-12);
        EXPECT_NEAR(clip.z, depth, 1e-12 * depth);
      }
      EXPECT_NEAR(ray.lengthPerDepth, glm::length(ray.direction), kTolerance);
    }
  }
}

TEST(Camera, FieldOfViewAndHeightAreVerticalAndFull) {
  const ImageSize size{300, 100};
  const Camera p = perspective();
  const Ray top = p.pixelRay(size, 149.5, -0.5);
  const Ray bottom = p.pixelRay(size, 149.5, 99.5);
  const double angle = std::acos(glm::dot(glm::normalize(top.direction), glm::normalize(bottom.direction)));
  EXPECT_NEAR(angle * 180 / std::acos(-1.0), 40.0, 1e-10);
  const Camera o = orthographic();
  EXPECT_NEAR(glm::length(o.pixelRay(size, 149.5, -0.5).origin - o.pixelRay(size, 149.5, 99.5).origin), 6.0, 1e-12);
}

TEST(Camera, PixelsAreSquare) {
  for (const Camera& camera : {perspective(), orthographic()}) {
    const ImageSize size{301, 97};
    const auto at = [&](double i, double j) {
      const Ray ray = camera.pixelRay(size, i, j);
      return ray.origin + 5.0 * ray.direction;
    };
    EXPECT_NEAR(glm::length(at(11, 7) - at(10, 7)), glm::length(at(11, 7) - at(11, 8)), 1e-12);
  }
}

TEST(Camera, OrthographicRaysStartOnTheEyesPlane) {
  const Camera camera = orthographic();
  const glm::dvec3 forward = glm::normalize(camera.center - camera.eye);
  const Ray ray = camera.pixelRay({10, 10}, 1, 8);
  EXPECT_NEAR(glm::dot(ray.origin - camera.eye, forward), 0.0, 1e-12);
  EXPECT_EQ(ray.lengthPerDepth, 1.0);
}

TEST(Camera, FullTurnComesBack) {
  const Camera camera = perspective();
  expectNear(camera.turned(360).eye, camera.eye);
  expectNear(camera.turned(90).turned(-90).eye, camera.eye);
  const Camera quarter = camera.turned(90);
  EXPECT_NEAR(glm::length(quarter.eye - camera.center), glm::length(camera.eye - camera.center), 1e-12);
  EXPECT_NEAR(glm::dot(quarter.eye - camera.center, camera.up), glm::dot(camera.eye - camera.center, camera.up), 1e-12);
}

TEST(Camera, WhatMakesNoPictureIsNamed) {
  const auto error = [](const auto& change, Camera camera = perspective()) {
    change(camera);
    return errorOf(ErrorCode::Input, [&] { validate(camera, "f: camera"); });
  };
  EXPECT_EQ(error([](Camera&) {}), "no error");
  EXPECT_EQ(error([](Camera& c) { c.center = c.eye; }),
            "f: camera: eye and center are both (10, -20, 7), expected two different points");
  EXPECT_EQ(error([](Camera& c) { c.up = c.center - c.eye; }),
            "f: camera: up is (-9, 22, -4), expected a direction that is not along the view");
  EXPECT_THAT(error([](Camera& c) { c.up = glm::dvec3(0); }), HasSubstr("up is (0, 0, 0)"));
  EXPECT_EQ(error([](Camera& c) { c.fovyDegrees = 180; }),
            "f: camera: fovy is 180, expected degrees between 0 and 180");
  EXPECT_EQ(error([](Camera& c) { c.fovyDegrees = 0; }), "f: camera: fovy is 0, expected degrees between 0 and 180");
  EXPECT_EQ(error([](Camera& c) { c.heightWorld = 0; }, orthographic()),
            "f: camera: height is 0, expected a positive number");
  EXPECT_EQ(error([](Camera& c) { c.eye.y = std::numeric_limits<double>::quiet_NaN(); }),
            "f: camera: eye[1] is nan, expected a finite number");
}

std::vector<glm::dvec3> corners(const glm::dvec3& high) {
  std::vector<glm::dvec3> result;
  for (int corner = 0; corner < 8; corner++)
    result.push_back((glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1) - 0.5) * high);
  return result;
}

TEST(FramingCamera, ShowsAllPointsAndFillsThePicture) {
  for (const ImageSize size : {ImageSize{100, 100}, ImageSize{400, 100}, ImageSize{50, 200}}) {
    for (const glm::dvec3& high : {glm::dvec3(1, 1, 1), glm::dvec3(100, 1, 1), glm::dvec3(1e-6, 2e-6, 5e-6)}) {
      const auto points = corners(high);
      const Camera camera = framingCamera(points, size);
      validate(camera, "test");
      double reach = 0.0;
      for (const glm::dvec3& p : points) {
        const glm::dvec4 clip = camera.clipFromWorld(size) * glm::dvec4(p, 1);
        EXPECT_GT(clip.w, 0.0);
        reach = std::max({reach, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
      }
      EXPECT_LT(reach, 1.0);
      EXPECT_GT(reach, 0.8);
    }
  }
  const std::vector<glm::dvec3> point = {glm::dvec3(3)};
  validate(framingCamera(point, {10, 10}), "a point");
}

}  // namespace
}  // namespace tetralux
