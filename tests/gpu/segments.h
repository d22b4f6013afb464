// Single segments, integrated on the device by the code that the raster pass runs.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "gpu/context.h"
#include "render/integration/integration_tables.h"
#include "volume/transfer_function.h"

namespace tetralux::test {

// Scalars are between 0 and 1; mesh units are world units.
struct Segment {
  double front, back, length;
};

// A scalar range of [0, 1] and mesh units that are world units.
render::MeshSpace unitSpace();

// What a segment of the device is in double precision: its scalars are rounded there.
Segment roundedSegment(const Segment& segment);

// Light and opacity of each segment.
std::vector<glm::vec4> integrateOnDevice(const gpu::Context& context, const TransferFunction& transfer,
                                         const std::vector<Segment>& segments,
                                         render::Integration integration = render::Integration::Exact,
                                         const render::TableOptions& options = {},
                                         const render::CellLengths& lengths = {},
                                         render::PartAccuracy accuracy = render::PartAccuracy::Full);

// Largest difference over segments and channels from the double-precision integral; not a number counts as a failure of
// the test.
double largestError(const gpu::Context& context, const TransferFunction& transfer, const std::vector<Segment>& segments,
                    render::Integration integration = render::Integration::Exact,
                    const render::TableOptions& options = {}, const render::CellLengths& lengths = {});

// The same for light, relative to the brightest channel of each segment; opacity must be right to `opacityLimit`.
double largestRelativeError(const gpu::Context& context, const TransferFunction& transfer,
                            const std::vector<Segment>& segments,
                            render::Integration integration = render::Integration::Exact,
                            const render::TableOptions& options = {}, const render::CellLengths& lengths = {},
                            double opacityLimit = 1e-5);

}  // namespace tetralux::test
