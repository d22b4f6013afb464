// Extreme cells.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "mesh/generate.h"
#include "stability/degenerate_cells.h"
#include "stability/parts.h"

namespace tetralux::stability {
namespace {

using CellMaker = TetMesh (*)(const Camera& camera, ImageSize size, std::uint32_t jitterUlp);

RegionCases degenerate(CellMaker make, Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.eye = {0.0, -8.0, 0.0};
  camera.fovyDegrees = 60.0;
  camera.heightWorld = 10.0;  // a pixel is 1/16
  constexpr ImageSize kSize{200, 160};
  RegionCases cases;
  for (const std::uint32_t jitter : {0u, 1u, 2u}) {
    PictureCase c = picture("jitter " + std::to_string(jitter), make(camera, kSize, jitter), camera);
    c.transfer = bands(0.0, 1.0, 3.0, 0.5);
    c.size = kSize;
    cases.pictures.push_back(std::move(c));
  }
  return cases;
}

RegionCases degenerateParallel() { return degenerate(degenerateCells, Projection::Orthographic); }
RegionCases degeneratePerspective() { return degenerate(degenerateCells, Projection::Perspective); }
RegionCases signsParallel() { return degenerate(signCells, Projection::Orthographic); }

RegionCases ordinary() {
  const TetMesh grid = unitMesh();
  const TetMesh delaunayMesh = randomDelaunay(400, 7);
  return {{picture("grid", grid, outside(grid)),
           picture("delaunay, parallel", delaunayMesh, outside(delaunayMesh, Projection::Orthographic))},
          {}};
}

// Flattened along an axis, and along none: then all digits of every coordinate are needed to tell the two sides of a
// cell. The picture's optical depth stays what it was.
RegionCases slivers(double height) {
  RegionCases cases;
  const TetMesh flat = flattenedDelaunay(300, 3, height);
  for (const TetMesh& mesh : {flat, turned(flat)}) {
    PictureCase c = picture(cases.pictures.empty() ? "along an axis" : "along none", mesh, outside(mesh));
    c.transfer = bands(0.0, 1.0, 6.0, height);
    cases.pictures.push_back(std::move(c));
  }
  return cases;
}

// Flat cells whose plane holds the eye.
RegionCases sliversEdgeOn(double height) {
  TetMesh mesh = flattenedDelaunay(300, 3, height);
  Camera camera = outside(mesh);
  camera.eye.z = camera.center.z;
  camera.fovyDegrees = 36.0 * std::min(1.0, 20.0 * height);
  return {{picture("edge-on", std::move(mesh), camera)}, {}};
}

// Each flatter than the one before; the last is 1e-7 of the first.
RegionCases sliverRow() {
  TetMesh chain = sliverChain(14, 0.32);
  Camera camera = outside(chain);
  camera.fovyDegrees = 20.0;
  return {{picture("chain", std::move(chain), camera, 30.0)}, {}};
}

RegionCases edgeRatio() {
  const TetMesh mesh = turned(gradedBox(6, 1e5));
  Camera close = outside(mesh);  // at the corner of the small cells
  close.center = mesh.point(0);
  close.eye = close.center - 1e-4 * (outside(mesh).center - mesh.point(0)) + glm::dvec3(1e-5, 0.0, 0.0);
  return {{picture("all", mesh, outside(mesh)), picture("small corner", mesh, close, 30.0)}, {}};
}

// One light everywhere: whatever the cells, a ray's opacity is its length's.
RegionCases edgeRatioOneLight() {
  const TetMesh mesh = gradedBox(8, 1e4);
  PictureCase c = picture("all", mesh, outside(mesh));
  c.transfer = TransferFunction({{0.0, {0.9, 0.5, 0.2}, 1.5}}, "one light");
  return {{c}, {}};
}

RegionCases cycles() {
  RegionCases cases;
  for (const TetMesh& mesh : {cyclicTriple(), cyclicOctahedron()}) {
    Camera camera = outside(mesh);
    camera.eye = camera.center - glm::dvec3(0.02, 0.03, 1.8) * mesh.bounds().diagonal();
    camera.up = {0.0, 1.0, 0.0};
    cases.pictures.push_back(picture("cycle", mesh, camera));
  }
  cases.pictures.back().name = "connected cycle";
  return cases;
}

// A grid without a third of its cells: what lies behind what is not known from shared faces alone.
RegionCases gaps() {
  TetMesh mesh = unitMesh(5);
  std::vector<CellVertices> kept;
  for (size_t i = 0; i < mesh.cells.size(); i++) {
    if (i * 2654435761u % 3 != 0) kept.push_back(mesh.cells[i]);
  }
  mesh.cells = std::move(kept);
  return {{picture("outside", mesh, outside(mesh)), picture("inside", mesh, inside(mesh))}, {}};
}

// Every other cell inverted; cells without volume: with a vertex twice, on a line, in a plane.
RegionCases brokenCells() {
  TetMesh mesh = unitMesh();
  for (size_t i = 0; i < mesh.cells.size(); i += 2) std::swap(mesh.cells[i][0], mesh.cells[i][1]);
  const size_t count = mesh.cells.size();
  for (size_t i = 0; i < count; i += 7) {
    const CellVertices v = mesh.cells[i];
    mesh.cells.push_back({v[0], v[0], v[1], v[2]});
    mesh.cells.push_back({v[0], v[0], v[1], v[1]});
    mesh.cells.push_back({v[3], v[3], v[3], v[3]});
  }
  return {{picture("outside", mesh, outside(mesh)), picture("inside", mesh, inside(mesh))}, {}};
}

RegionCases duplicateCells() {
  TetMesh mesh = unitMesh(3);
  const std::vector<CellVertices> cells = mesh.cells;
  for (size_t i = 0; i < cells.size(); i += 5) mesh.cells.push_back(cells[i]);
  return {{picture("outside", mesh, outside(mesh))}, {}};
}

// Two meshes of the same space, one of them smaller and turned.
RegionCases overlappingCells() {
  TetMesh mesh = unitMesh(2);
  const TetMesh other = moved(turned(unitMesh(2)), 0.7, {0.4, 0.3, 0.1});
  const auto offset = static_cast<std::uint32_t>(mesh.pointCount());
  for (size_t i = 0; i < other.pointCount(); i++) pointsOf(mesh).push_back(other.point(i));
  for (const CellVertices& v : other.cells)
    mesh.cells.push_back({v[0] + offset, v[1] + offset, v[2] + offset, v[3] + offset});
  mesh.pointArrays.clear();
  addPreferredField(mesh, "scalar", waveField);
  return {{picture("outside", mesh, outside(mesh))}, {}};
}

RegionCases unusedArrays() {
  TetMesh mesh = unitMesh();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  mesh.pointArrays.push_back({"nan", 1, std::vector<float>(mesh.pointCount(), nan)});
  mesh.cellArrays.push_back({"infinite", 1, std::vector<double>(mesh.cellCount(), infinity)});
  return {{picture("outside", mesh, outside(mesh))}, {}};
}

}  // namespace

std::vector<Region> shapeRegions() {
  return {
      {"ordinary", "nothing is extreme: what the others are compared with", ordinary},
      {"degenerate parallel", "vertices on edges and vertices; faces edge-on; 0 to 2 ulp aside", degenerateParallel},
      {"degenerate perspective", "the same on rays from an eye", degeneratePerspective},
      {"sign patterns", "all fifty sign patterns of a projected cell; 0 to 2 ulp aside", signsParallel},
      {"slivers 1e-3", "cells of a height of 1e-3 of their width", [] { return slivers(1e-3); }},
      {"slivers 1e-4", "... of 1e-4", [] { return slivers(1e-4); }},
      {"slivers 1e-5", "... of 1e-5", [] { return slivers(1e-5); }},
      {"slivers 1e-7", "... of 1e-7", [] { return slivers(1e-7); }},
      {"edge-on slivers 1e-3", "the eye in the plane of such cells", [] { return sliversEdgeOn(1e-3); }},
      {"edge-on slivers 1e-5", "... of 1e-5", [] { return sliversEdgeOn(1e-5); }},
      {"edge-on slivers 1e-7", "... of 1e-7", [] { return sliversEdgeOn(1e-7); }},
      {"sliver chain", "cells each flatter than the last, down to 1e-7", sliverRow},
      {"edge ratio 1e5", "edges from 1 to 1e-5 in one mesh", edgeRatio},
      {"edge ratio 1e4 one light", "cell lengths over four decades and one colour", edgeRatioOneLight},
      {"cycles", "cells that hide each other in a circle", cycles},
      {"gaps", "a mesh with a third of its cells missing", gaps},
      {"broken cells", "inverted cells and cells without volume", brokenCells},
      {"duplicate cells", "every fifth cell twice", duplicateCells},
      {"overlapping cells", "two meshes in the same space", overlappingCells},
      {"unused arrays", "NaN and infinity in arrays that are not drawn", unusedArrays}};
}

}  // namespace tetralux::stability
