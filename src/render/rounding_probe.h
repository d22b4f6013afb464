// How a device rounds when it blends.
#pragma once

#include "gpu/commands.h"

namespace tetralux::render {

// Whether blending into RGBA16F rounds to the nearest value; otherwise towards zero, as Mesa's software device does.
// Vulkan leaves it open. Blends one pixel to find out.
bool halfBlendingRoundsToNearest(const gpu::Context& context);

inline constexpr double kHalfFloatLimit = 1.0 / 512.0;

// Whether a picture blended in RGBA16F errs by less than `limit` of its brightest value.
//   roundings   sum T_i^2 (rounding to nearest) or sum T_i (towards zero) over the layers of the worst pixel, T_i the
//               transmittance in front of layer i (shared/target_output.h)
bool halfFloatHolds(double roundings, bool roundsToNearest, double limit = kHalfFloatLimit);

}  // namespace tetralux::render
