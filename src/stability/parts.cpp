#include "stability/parts.h"

#include <algorithm>
#include <utility>

#include "mesh/generate.h"

namespace tetralux::stability {

std::vector<glm::dvec3>& pointsOf(TetMesh& mesh) { return std::get<std::vector<glm::dvec3>>(mesh.points); }

TransferFunction bands(double low, double high, double depth, double extent) {
  const auto s = [&](double share) { return low * (1.0 - share) + high * share; };
  const double tau = depth / extent;
  return TransferFunction({{s(0.0), {0.1, 0.1, 0.8}, 0.02 * tau},
                           {s(0.3), {0.1, 0.7, 0.2}, 0.3 * tau},
                           {s(0.5), {0.9, 0.8, 0.1}, 0.0},
                           {s(0.7), {0.9, 0.3, 0.1}, tau},
                           {s(1.0), {0.8, 0.1, 0.3}, 0.2 * tau}},
                          "bands");
}

Camera outside(const TetMesh& mesh, Projection projection) {
  const Bounds bounds = mesh.bounds();
  const double size = bounds.diagonal();
  Camera camera;
  camera.projection = projection;
  camera.center = bounds.center();
  camera.eye = camera.center + size * glm::dvec3(0.9, -1.1, 0.6);
  camera.fovyDegrees = 36.0;
  camera.heightWorld = 0.9 * size;
  return camera;
}

Camera inside(const TetMesh& mesh) {
  const Bounds bounds = mesh.bounds();
  const glm::dvec3 extent = bounds.high - bounds.low;
  Camera camera;
  camera.eye = bounds.center() + 0.0713 * extent;
  camera.center = camera.eye + bounds.diagonal() * glm::dvec3(-0.7, 0.6, -0.2);
  camera.fovyDegrees = 75.0;
  return camera;
}

TetMesh unitMesh(std::uint32_t n) {
  return jitteredGrid(n, n, n, glm::dvec3(0.0), glm::dvec3(1.0), 0.15, 3, waveField);
}

TetMesh moved(TetMesh mesh, double scale, const glm::dvec3& offset) {
  for (glm::dvec3& p : pointsOf(mesh)) p = scale * p + offset;
  return mesh;
}

TetMesh turned(TetMesh mesh) {
  constexpr double kTurn[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0.0}, {0.48, 0.64, 0.6}};
  for (glm::dvec3& p : pointsOf(mesh)) {
    const glm::dvec3 q = p;
    for (int row = 0; row < 3; row++) p[row] = kTurn[row][0] * q.x + kTurn[row][1] * q.y + kTurn[row][2] * q.z;
  }
  return mesh;
}

TetMesh withRange(TetMesh mesh, double low, double high) {
  const ScalarField field = scalarField(mesh, "", "stability");
  std::vector<double> values = field.values;
  for (double& value : values) value = low + value * (high - low);
  mesh.pointArrays.clear();
  mesh.pointArrays.push_back({field.name, 1, std::move(values)});
  return mesh;
}

PictureCase picture(std::string name, TetMesh mesh, const Camera& camera, double depth) {
  const ScalarField field = scalarField(mesh, "", "stability");
  const double extent = mesh.bounds().diagonal();
  return {std::move(name), std::move(mesh), bands(field.low, field.high, depth, extent), camera};
}

}  // namespace tetralux::stability
