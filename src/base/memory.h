// How much memory this process takes.
#pragma once

#include <cstdint>

namespace tetralux {

// Largest number of bytes that were resident at once since the process began: what of a software device's memory was
// touched is among them.
std::uint64_t peakMemoryBytes();

// Keeps freed blocks below 256 MiB in the process. By default the C library takes every large one from the system and
// gives it back, and each page of it is made anew and zeroed at its first touch: more work than what is then done with a
// picture of a sequence. To be called once, before memory is taken. Nothing where the C library is not GNU's.
void keepFreedMemory();

}  // namespace tetralux
