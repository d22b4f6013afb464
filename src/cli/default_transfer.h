// A readable transfer function for a field that nobody has written one for.
#pragma once

#include <string>

#include "mesh/tet_mesh.h"
#include "volume/transfer_function.h"

namespace tetralux::cli {

// A colour map over the field's range, with extinctions that show every part of it (volume/equalize.h).
//   preset   name of a colour map; empty: "diverging", centred on zero, for a field that has both signs to a similar
//            extent, else "flow"
TransferFunction defaultTransfer(const TetMesh& mesh, const ScalarField& field, const std::string& preset);

}  // namespace tetralux::cli
