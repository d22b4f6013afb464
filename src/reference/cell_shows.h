// Whether a cell can show anything.
#pragma once

#include "reference/cell_ray.h"
#include "reference/ray_caster.h"

namespace tetralux::reference {

// Whether the volume in a cell may absorb or emit anywhere; false only where it certainly does not.
bool volumeMayShow(const ReferenceScene& scene, size_t cell);

// Whether a segment may cross an isosurface that shows, or does but for rounding.
bool isosurfaceMayShow(const ReferenceScene& scene, const CellSegment& segment);

// Whether a cell may show anything to any ray.
bool cellMayShow(const ReferenceScene& scene, size_t cell);

}  // namespace tetralux::reference
