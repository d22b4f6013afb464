// The radix sort's parameters (see sort/).
#ifndef TETRALUX_SHARED_SORT_H
#define TETRALUX_SHARED_SORT_H

#include "types.h"

SHARED_BEGIN

// Tiled variant: a workgroup ranks this many keys, each subgroup a run of them in order.
SHARED_CONST uint SORT_TILE_THREADS = 256;
SHARED_CONST uint SORT_TILE_KEYS_PER_THREAD = 8;
SHARED_CONST uint SORT_TILE_KEYS = 2048;
// Smallest subgroup for which the tile's counters (subgroups x digits) fit the 32 KiB of shared memory that every
// device has.
SHARED_CONST uint SORT_TILE_LEAST_SUBGROUP = 8;

// Chunked variant: an invocation owns a run of keys and counters of its own in shared memory.
SHARED_CONST uint SORT_CHUNK_THREADS = 16;
// Runs, enough for some cores of some lanes each; more of them only where a run would be longer than the next limit.
SHARED_CONST uint SORT_LEAST_CHUNKS = 128;
// Mesa's software device ends every loop after 65535 rounds, silently.
SHARED_CONST uint SORT_LONGEST_CHUNK = 32768;

SHARED_END

#endif
