// How much memory this process takes.
#pragma once

#include <cstdint>

namespace tetralux {

// Largest number of bytes that were resident at once since the process began: what of a software device's memory was
// touched is among them.
std::uint64_t peakMemoryBytes();

}  // namespace tetralux
