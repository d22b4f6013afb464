// Extreme eyes and pictures.
#include <glm/geometric.hpp>

#include "mesh/generate.h"
#include "stability/parts.h"

namespace tetralux::stability {
namespace {

// A cell near the middle of the unit mesh.
CellVertices middleCell(const TetMesh& mesh) { return mesh.cells[mesh.cellCount() / 2 + 3]; }

// From `eye`, through the mesh's middle and beyond, or along a direction of no particular kind where it is there.
Camera from(const TetMesh& mesh, const glm::dvec3& eye, const glm::dvec3& toward) {
  Camera camera = outside(mesh);
  camera.eye = eye;
  camera.center = toward;
  camera.fovyDegrees = 75.0;
  return camera;
}

RegionCases eyeOn(const glm::dvec4& weights) {
  const TetMesh mesh = unitMesh();
  const CellVertices v = middleCell(mesh);
  glm::dvec3 eye(0.0);
  for (int i = 0; i < 4; i++) eye += weights[i] * mesh.point(v[static_cast<size_t>(i)]);
  return {{picture("oblique", mesh, from(mesh, eye, eye + glm::dvec3(0.31, 0.47, -0.19))),
           picture("at a vertex", mesh, from(mesh, eye, mesh.point(v[3]) + glm::dvec3(0.0, 0.0, 1e-9)))},
          {}};
}

RegionCases eyeOnVertex() { return eyeOn({1.0, 0.0, 0.0, 0.0}); }
RegionCases eyeOnEdge() { return eyeOn({0.5, 0.5, 0.0, 0.0}); }
RegionCases eyeOnFace() { return eyeOn({0.25, 0.25, 0.5, 0.0}); }

// Outside, in the planes of a regular grid's faces.
RegionCases eyeInPlanes() {
  const TetMesh mesh = kuhnGrid(4, 4, 4, glm::dvec3(0.0), glm::dvec3(1.0), waveField);
  Camera camera = from(mesh, {0.53, -1.5, 0.25}, {0.53, 0.5, 0.25});
  camera.fovyDegrees = 50.0;
  Camera parallel = camera;
  parallel.projection = Projection::Orthographic;
  parallel.heightWorld = 1.3;
  return {{picture("perspective", mesh, camera), picture("parallel", mesh, parallel)}, {}};
}

// Parallel rays in a grid's faces: rows of pixel centres on its planes, diagonals of them on its cut diagonals. A ray
// between two cells belongs to one of them, to either.
RegionCases raysInFaces() {
  const TetMesh mesh = kuhnGrid(4, 4, 4, glm::dvec3(0.0), glm::dvec3(1.0), waveField);
  Camera camera = from(mesh, {0.5, -1.5, 0.5}, {0.5, 0.5, 0.5});
  camera.projection = Projection::Orthographic;
  camera.heightWorld = 1.25;
  PictureCase c = picture("parallel", mesh, camera);
  c.size = {50, 40};  // a pixel is 1/32
  c.camera.eye.x = c.camera.center.x = 0.5 + 1.0 / 64.0;
  c.camera.eye.z = c.camera.center.z = 0.5 + 1.0 / 64.0;
  return {{c}, {}};
}

RegionCases eyeInSliver() {
  RegionCases cases;
  for (const double factor : {1e-3, 1e-5}) {
    const TetMesh mesh = flattenedDelaunay(300, 3, factor);
    const CellVertices v = mesh.cells[mesh.cellCount() / 2];
    const glm::dvec3 eye = 0.25 * (mesh.point(v[0]) + mesh.point(v[1]) + mesh.point(v[2]) + mesh.point(v[3]));
    for (const glm::dvec3& direction : {glm::dvec3(0.3, 0.5, 0.0), glm::dvec3(0.3, 0.5, 0.4)})
      cases.pictures.push_back(picture("in a sliver", mesh, from(mesh, eye, eye + direction)));
  }
  return cases;
}

// The mesh fills the picture.
RegionCases fieldOfView(double degrees, double distance) {
  const TetMesh mesh = unitMesh();
  Camera camera = outside(mesh);
  camera.eye = camera.center + distance * glm::normalize(camera.eye - camera.center);
  camera.fovyDegrees = degrees;
  return {{picture("outside", mesh, camera)}, {}};
}

RegionCases narrowView() { return fieldOfView(1.0, 80.0); }

RegionCases wideView() {
  RegionCases cases = fieldOfView(170.0, 0.62);
  const TetMesh mesh = unitMesh();
  Camera camera = inside(mesh);
  camera.fovyDegrees = 170.0;
  cases.pictures.push_back(picture("inside", mesh, camera));
  return cases;
}

RegionCases ofSize(ImageSize size) {
  const TetMesh mesh = unitMesh();
  Camera parallel = outside(mesh, Projection::Orthographic);
  parallel.heightWorld = 1.8 * size.height / size.width;
  Camera perspective = outside(mesh);
  perspective.fovyDegrees *= static_cast<double>(size.height) / size.width;
  RegionCases cases;
  for (const Camera& camera : {perspective, parallel}) {
    cases.pictures.push_back(picture("line", mesh, camera));
    cases.pictures.back().size = size;
  }
  return cases;
}

RegionCases onePixel() { return ofSize({1, 1}); }
RegionCases longLine() { return ofSize({16384, 1}); }

}  // namespace

std::vector<Region> viewRegions() {
  return {{"eye on a vertex", "the eye on a vertex inside the mesh", eyeOnVertex},
          {"eye on an edge", "the eye on an edge inside the mesh", eyeOnEdge},
          {"eye on a face", "the eye on a face inside the mesh", eyeOnFace},
          {"eye in planes", "the eye in the planes of many faces", eyeInPlanes},
          {"rays in faces", "parallel rays that lie in faces and edges of a grid", raysInFaces},
          {"eye in a sliver", "the eye inside a cell of height 1e-3 and 1e-5", eyeInSliver},
          {"view of 1 degree", "a field of view of 1 degree", narrowView},
          {"view of 170 degrees", "a field of view of 170 degrees, from outside and inside", wideView},
          {"one pixel", "a picture of 1 x 1", onePixel},
          {"long line", "a picture of 16384 x 1", longLine}};
}

}  // namespace tetralux::stability
