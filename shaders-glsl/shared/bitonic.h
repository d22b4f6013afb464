// The bitonic sort's parameters (see sort/bitonic_*).
#ifndef TETRALUX_SHARED_BITONIC_H
#define TETRALUX_SHARED_BITONIC_H

#include "types.h"

SHARED_BEGIN

SHARED_CONST uint BITONIC_THREADS = 256;
// Pairs that a workgroup sorts in shared memory: 16 KiB of it, the least that Vulkan grants. A power of two.
SHARED_CONST uint BITONIC_BLOCK = 2048;

SHARED_END

#endif
