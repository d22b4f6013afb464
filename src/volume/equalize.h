// An opacity that shows every part of a scalar's range, whatever its distribution.
#pragma once

#include <functional>
#include <vector>

#include "volume/transfer_function.h"

namespace tetralux {

// A scalar value and the volume it stands for (any unit, >= 0).
struct WeightedScalar {
  double s = 0.0;
  double weight = 0.0;
};

// Sets the extinctions of a colour map so that each part of the scalar's range, from one control point's
// neighbourhood to the next, absorbs about the same share of light, and the whole about `opticalDepth` along a ray of
// length `lengthWorld`: common values become thin, rare ones dense, within a factor of 100.
//   colors         control points over the field's range; their tau weighs the parts against each other (0: invisible)
//   samples        the field's values with the volumes they occupy; may be empty
//   lengthWorld    > 0, world units
//   opticalDepth   > 0
TransferFunction equalizedOpacity(const std::vector<ControlPoint>& colors, const std::vector<WeightedScalar>& samples,
                                  double lengthWorld, double opticalDepth);

}  // namespace tetralux
