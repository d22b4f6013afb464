// Lets a header be read by C++ and by GLSL. Structures here consist of 16-byte vectors or of 4-byte scalars, so that
// every layout rule (std140, scalar) places them alike.
#ifndef TETRALUX_SHARED_TYPES_H
#define TETRALUX_SHARED_TYPES_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#define SHARED_BEGIN namespace tetralux::shared { using uint = std::uint32_t; using vec2 = glm::vec2; using vec4 = glm::vec4;
#define SHARED_END }
#define SHARED_CONST inline constexpr
#define SHARED_FUNCTION inline constexpr
#else
#define SHARED_BEGIN
#define SHARED_END
#define SHARED_CONST const
#define SHARED_FUNCTION
#endif

#endif
