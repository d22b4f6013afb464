// The device that kernels are timed on, and what they are timed with.
#pragma once

#include <benchmark/benchmark.h>

#include "gpu/context.h"
#include "gpu/recorder.h"
#include "mesh/generate.h"
#include "view/camera.h"
#include "volume/transfer_function.h"

namespace tetralux::bench {

// The first usable device, or the one that TETRALUX_TEST_DEVICE names by index or a part of its name; null where there
// is none. Made once. Without validation, which would be timed, too.
const gpu::Context* device();

// Gives the device back. A driver takes itself down in destructors of static objects, maybe before ours.
void releaseDevice();

// What a recorder's pass took since the recorder was made, seconds. Throws CheckFailure when it had no such pass.
double passSeconds(const gpu::Recorder& recorder, const std::string& pass);

// A jittered grid of 101,400 cells in the unit cube, a camera that sees all of it, and five control points.
const TetMesh& gridMesh();
Camera gridCamera();
TransferFunction gridTransfer();

}  // namespace tetralux::bench
