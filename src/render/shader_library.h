// The compiled shaders that come with the program.
#pragma once

#include <string>

#include "gpu/shader.h"

namespace tetralux::render {

// The module compiled from shaders-glsl/NAME. Throws CheckFailure for a name that does not exist.
gpu::Shader loadShader(const gpu::Context& context, const std::string& name);

}  // namespace tetralux::render
