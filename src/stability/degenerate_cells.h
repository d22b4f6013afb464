// Cells whose projections are degenerate.
#pragma once

#include <cstdint>

#include "mesh/tet_mesh.h"
#include "view/camera.h"

namespace tetralux::stability {

// Separate cells, each in a square of its own of the camera's picture, for every choice of four of the nine points of a
// 3 x 3 grid on the screen, repeated ones included (495 cells), at depths of small whole numbers: vertices on edges and
// on vertices, collinear and coincident points, faces seen edge-on, cells without volume. Point array "scalar".
//   camera      gives the rays; under perspective, points lie on the rays of the grid's points, to rounding
//   jitterUlp   every coordinate is moved by up to so many units in the last place of a single-precision number
TetMesh degenerateCells(const Camera& camera, ImageSize size, std::uint32_t jitterUlp);

// The same number of cells with vertices on a 5 x 5 x 5 grid at random: seen along the grid's axis all fifty sign
// patterns of a projected cell's four faces occur.
TetMesh signCells(const Camera& camera, ImageSize size, std::uint32_t jitterUlp);

}  // namespace tetralux::stability
