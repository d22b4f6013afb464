// Generated meshes: fixtures for tests and benchmarks, and the demo, without downloads. One header per idea; all of
// them guarantee the invariants of TetMesh.
#pragma once

#include "mesh/delaunay.h"        // delaunay
#include "mesh/field_function.h"  // FieldFunction, addPointField, waveField, distanceField
#include "mesh/grid.h"            // kuhnGrid, jitteredGrid, gradedBox
#include "mesh/hard_meshes.h"     // randomDelaunay, flattenedDelaunay, twistedDelaunay, sliverChain, cyclic meshes
#include "mesh/orbital.h"         // hydrogenOrbital
