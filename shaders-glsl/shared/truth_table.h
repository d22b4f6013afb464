// The ternary truth table (Marroquim et al. 2008, section 4.1): from the signs of a cell's four face areas to its
// projection class, its centre and its ring. Index: 27 t0 + 9 t1 + 3 t2 + t3 with t = sign + 1.
#ifndef TETRALUX_SHARED_TRUTH_TABLE_H
#define TETRALUX_SHARED_TRUTH_TABLE_H

#include "types.h"

SHARED_BEGIN

SHARED_CONST uint TRUTH_TABLE_SIZE = 81;

// An entry, from the lowest bit:
//    8 bits  ring: vertex i in bits 2i and 2i+1; a ring of three repeats its first
//    3 bits  centre: a vertex, or 4 for the crossing of the two edges between opposite ring vertices
//    3 bits  triangles with an area: 3, 4, 2, 1 for classes 1 to 4; 0 for signs that no projection with an area has
//    3 bits  class 1 to 4, or 0
SHARED_FUNCTION uint truthRing(uint entry, uint i) { return (entry >> (2u * i)) & 3u; }
SHARED_FUNCTION uint truthCentre(uint entry) { return (entry >> 8u) & 7u; }
SHARED_FUNCTION uint truthTriangles(uint entry) { return (entry >> 11u) & 7u; }
SHARED_FUNCTION uint truthClass(uint entry) { return (entry >> 14u) & 7u; }

SHARED_END

#endif
