// Single segments, integrated on the device by the code that the raster pass runs.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "gpu/context.h"
#include "render/integration/integration_tables.h"
#include "render/mesh_space.h"
#include "volume/transfer_function.h"

namespace tetralux::stability {

// Scalars are between 0 and 1; mesh units are world units.
struct Segment {
  double front, back, length;
};

// A scalar range of [0, 1] and mesh units that are world units.
render::MeshSpace unitSpace();

// What a segment of the device is in double precision: its scalars are rounded there.
Segment roundedSegment(const Segment& segment);

// Light and opacity of each segment. Throws Error(Device).
std::vector<glm::vec4> integrateOnDevice(const gpu::Context& context, const TransferFunction& transfer,
                                         const std::vector<Segment>& segments,
                                         render::Integration integration = render::Integration::Exact,
                                         const render::TableOptions& options = {},
                                         const render::CellLengths& lengths = {},
                                         render::PartAccuracy accuracy = render::PartAccuracy::Full);

}  // namespace tetralux::stability
