// Scalars given as functions of the place.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <string>

#include "mesh/tet_mesh.h"

namespace tetralux {

// A scalar at a place in the world. Called from several threads at a time, so it keeps no state.
using FieldFunction = std::function<double(const glm::dvec3& position)>;

// Adds a point array of doubles with field(position) for every point.
void addPointField(TetMesh& mesh, const std::string& name, const FieldFunction& field);

// The same, and makes it the mesh's preferred field.
void addPreferredField(TetMesh& mesh, const std::string& name, const FieldFunction& field);

// The field of generated meshes that are about geometry: sines of the three coordinates with about one period in a
// unit length, between 0 and 1 everywhere.
double waveField(const glm::dvec3& position);

// |position - center|: its isosurfaces are spheres, and its gradient has length 1 everywhere but at the centre.
FieldFunction distanceField(const glm::dvec3& center);

}  // namespace tetralux
