// Extreme coordinates and extreme numbers of cells.
#include "mesh/generate.h"
#include "stability/parts.h"

namespace tetralux::stability {
namespace {

RegionCases at(double scale, const glm::dvec3& offset) {
  const TetMesh mesh = moved(unitMesh(), scale, offset);
  return {{picture("outside", mesh, outside(mesh)), picture("parallel", mesh, outside(mesh, Projection::Orthographic)),
           picture("inside", mesh, inside(mesh))},
          {}};
}

RegionCases farAway() { return at(1.0, {1e6, -1e6, 1e6}); }

// Spacings of 1e-9 of the coordinates' size: eight decimal digits are gone before the mesh is read.
RegionCases farAndSmall() { return at(1e-2, {1e6, 0.0, 0.0}); }
RegionCases tiny() { return at(1e-9, glm::dvec3(0.0)); }
RegionCases huge() { return at(1e9, glm::dvec3(0.0)); }

// A column of flat cells seen through its length.
PictureCase column(std::string name, std::uint32_t layers, double depth, Projection projection) {
  TetMesh mesh = kuhnGrid(1, 1, layers, {0.0, 0.0, 0.0}, {1.0, 1.0, 4.0}, waveField);
  Camera camera;
  camera.projection = projection;
  camera.eye = {0.47, 0.52, -6.0};
  camera.center = {0.5, 0.5, 0.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.fovyDegrees = 8.0;
  camera.heightWorld = 0.9;
  PictureCase c = picture(std::move(name), std::move(mesh), camera);
  c.transfer = bands(0.0, 1.0, depth, 4.0);
  return c;
}

// Three cells of a box lie behind each other.
RegionCases deep() {
  return {{column("5000 thin layers", 1667, 3.0, Projection::Perspective),
           column("5000 layers", 1667, 60.0, Projection::Orthographic)},
          {}};
}

RegionCases layers() {
  return {{column("200 layers", 67, 3.0, Projection::Perspective),
           column("1000 layers", 333, 3.0, Projection::Perspective)},
          {}};
}

}  // namespace

std::vector<Region> placeRegions() {
  return {{"far away", "a mesh of size 1 at a distance of 1e6 from the origin", farAway},
          {"far and small", "a mesh of size 0.01 at a distance of 1e6", farAndSmall},
          {"scale 1e-9", "a mesh of size 1e-9", tiny},
          {"scale 1e9", "a mesh of size 1e9", huge},
          {"layers", "200 and 1000 cells behind each other", layers},
          {"5000 layers", "5000 cells behind each other, thin and dense", deep}};
}

}  // namespace tetralux::stability
