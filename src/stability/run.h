// Methods against the double-precision answer, region by region.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "gpu/context.h"
#include "stability/method.h"
#include "stability/region.h"

namespace tetralux::stability {

// What became of a method in a region: the worst of the region's cases.
struct Outcome {
  std::string region;
  std::string method;           // Method::fullName()
  bool applies = true;          // false where a region has no such case, or the method refuses it
  double rmse = 0.0;            // over pixels, or segments, and their four channels
  double largest = 0.0;         // of them; a value that is not a number counts as 1
  std::uint64_t nonFinite = 0;  // values, over all cases
  std::string worstCase;        // of `largest`

  bool keepsLimits() const { return rmse <= kLargestRmse && largest <= kLargestError && nonFinite == 0; }
};

// Runs every case of a region by every method, one outcome each in the order of `methods`. Throws Error(Device).
std::vector<Outcome> runRegion(const gpu::Context& context, const Region& region, std::span<const Method> methods);

}  // namespace tetralux::stability
