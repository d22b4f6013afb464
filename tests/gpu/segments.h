// Single segments, integrated on the device by the code that the raster pass runs, in tests.
#pragma once

#include "stability/segments.h"

namespace tetralux::test {

using stability::integrateOnDevice;
using stability::roundedSegment;
using stability::Segment;
using stability::unitSpace;

// By how much a sampler's fraction between two texels may be off: half a step of the device's. Software devices have
// whole floats there.
double samplerFractionError(const gpu::Context& context);

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
