// What a mesh takes on the device, known before it is there.
#pragma once

#include <cstdint>

#include "mesh/tet_mesh.h"
#include "render/projection.h"

namespace tetralux::render {

// Bytes that a renderer takes for a mesh at least, before its first frame: the mesh, and who is whose neighbour for
// rays that walk, or keys, indices and a batch of cells for those that are projected. Boundary faces are not known yet,
// nor what an order needs.
//   projection   not CellProjection::Auto
//   hasFloat64   of the device
std::uint64_t leastMeshBytes(std::uint64_t cells, std::uint64_t points, FieldAssociation association,
                             CellProjection projection, bool hasFloat64);

}  // namespace tetralux::render
