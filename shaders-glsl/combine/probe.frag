// A constant colour, to see what blending makes of it (render/rounding_probe.h).
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(push_constant, scalar) uniform Push { vec4 given; };

layout(location = 0) out vec4 color;

void main() { color = given; }
