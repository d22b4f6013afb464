// What an appearance needs of a mesh's arrays.
#pragma once

#include <string_view>

#include "mesh/tet_mesh.h"
#include "volume/appearance.h"

namespace tetralux {

// Computes gradients, modulating numbers and colours at vertices and reads surfaces: only what the appearance uses.
// There are gradients where appearance.needsGradients() says so. What belongs to the volume alone (modulators, gradient
// magnitudes, rgba) is left out, and not looked for, where the volume is not visible; there are as many modulators as
// modulations in any case.
// Throws Error(Input) where an array or file is missing or unfit, or where a field of one number per cell is asked for
// what it does not have (isosurfaces, gradients).
//   place   begins messages about the mesh, usually its file's name
AppearanceData makeAppearanceData(const Appearance& appearance, const TetMesh& mesh, const ScalarField& field,
                                  std::string_view place);

}  // namespace tetralux
