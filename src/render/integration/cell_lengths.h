// How long rays run inside the cells of a mesh.
#pragma once

#include "render/gpu_mesh.h"
#include "render/pipeline_variants.h"

namespace tetralux::render {

// World-independent: mesh units, both > 0 (1 for a mesh without cells of any size).
struct CellLengths {
  float longest = 1.0f;  // no segment is longer: the longest edge
  // Mean length of the segments of rays of all directions that hit a cell: a convex body's mean chord is 4
  // volume/surface (Cauchy 1850), and it is hit in proportion to its surface, so for all cells it is 4
  // sum(volume)/sum(surface).
  float mean = 1.0f;
};

// Measured on the device, where the mesh is; takes about as long as a cull pass.
CellLengths measureCellLengths(const gpu::Context& context, const GpuMesh& mesh, bool wideAddressing);

}  // namespace tetralux::render
