// What a device needs for the least that a pass could be: times to compare a pass's own with.
#pragma once

#include <cstdint>

#include "gpu/context.h"
#include "render/mesh_space.h"
#include "view/camera.h"

namespace tetralux::render {

// An empty submission, until the host knows that it is done: median, ms. Nothing that is waited for costs less.
double emptySubmitMs(const gpu::Context& context);

// A copy from buffer to buffer that reads and writes so many bytes together: median, ms. What is beyond 512 MiB is not
// copied but reckoned from that. 0 for no bytes.
double copyMs(const gpu::Context& context, std::uint64_t bytes);

// The camera moved to the right until no pixel's ray meets the mesh: what a frame costs when there is nothing to see.
// Depths stay what they were, so the frame's pipelines are the same.
Camera besideMesh(const Camera& camera, ImageSize size, const MeshSpace& space);

}  // namespace tetralux::render
