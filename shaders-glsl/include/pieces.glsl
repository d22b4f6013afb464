#ifndef PIECES_GLSL
#define PIECES_GLSL
// Of lists in pieces (gpu/pieced_buffer.h): as many as 2^30 cells in pieces of 256. Nothing is that long; an array without a length
// would make glslang ask for descriptor indexing.
const uint kMostPieces = 1u << 22;
#endif
