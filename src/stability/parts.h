// Meshes, transfer functions and cameras that several regions are put together from.
#pragma once

#include "stability/region.h"

namespace tetralux::stability {

// Bands of colour over scalars from `low` to `high`, with a gap and a peak: a picture shows where a ray was.
//   depth    largest optical depth of a ray of length `extent`
//   extent   world units
TransferFunction bands(double low, double high, double depth, double extent);

// From outside, the whole mesh filling most of the picture, no axis level. Distances are relative to the mesh's size.
Camera outside(const TetMesh& mesh, Projection projection = Projection::Perspective);

// From a place near the mesh's centre that lies on nothing in particular.
Camera inside(const TetMesh& mesh);

// A jittered grid of `n` boxes along each edge of the unit cube, with the wave field.
TetMesh unitMesh(std::uint32_t n = 4);

// Points multiplied by `scale`, then moved; cells and arrays as they are.
TetMesh moved(TetMesh mesh, double scale, const glm::dvec3& offset);

// Points turned about an oblique axis by a matrix of fractions: no coordinate has few digits after it.
TetMesh turned(TetMesh mesh);

// Values of the preferred field mapped to low + value * (high - low).
TetMesh withRange(TetMesh mesh, double low, double high);

// A picture in bands over the mesh's own scalar range, of optical depth 6 through its extent.
PictureCase picture(std::string name, TetMesh mesh, const Camera& camera, double depth = 6.0);

// The double points of a generated mesh.
std::vector<glm::dvec3>& pointsOf(TetMesh& mesh);

}  // namespace tetralux::stability
