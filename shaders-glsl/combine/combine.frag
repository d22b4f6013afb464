// A chunk of cells, to be blended over what lies behind it.
#version 460
#extension GL_EXT_samplerless_texture_functions : require

layout(binding = 0) uniform texture2D chunk;

layout(location = 0) out vec4 color;

void main() { color = texelFetch(chunk, ivec2(gl_FragCoord.xy), 0); }
