// Which segment of a ray goes on where another one ends.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reference/cell_ray.h"

namespace tetralux::reference {

constexpr std::uint32_t kNoSegment = 0xffffffff;

// Cells are met one by one, so depth and scalar of a place in the face of two cells differ by rounding, and whether the
// scalar there is below a value may have two answers. This finds for every segment the earlier one from whose end it
// goes on, so that its scalar can be used for both: kNoSegment where there is none, as where the ray enters the mesh.
// Ends and beginnings agree in depth and in scalar; each end has one continuation at most.
//   segments          in the order of the ray
//   scalarTolerance   >= 0; a scalar may differ by as much
std::vector<std::uint32_t> predecessors(std::span<const CellSegment> segments, double scalarTolerance);

}  // namespace tetralux::reference
