// Isosurfaces that a ray crosses inside cells (Roettger, Kraus and Ertl 2000, section 4; Marroquim et al. 2008, section 5).
//
// The control points of the walk (ray_parts.glsl) hold every isovalue, so a segment is split exactly there, surfaces that a cell does
// not cross cost nothing, and which side of a surface the ray is on is carried from cell to cell: a surface through a shared face,
// edge or vertex is met once.
//
// Before including: face_meeting.glsl, illumination.glsl; VERTEX_GRADIENTS is a binding number.
layout(binding = VERTEX_GRADIENTS) uniform samplerBuffer vertexGradients;  // mesh space, in units of the longest

vec3 vertexGradient(uint vertex) { return texelFetch(vertexGradients, int(vertex)).xyz; }

// The shares of a face's corners where the ray meets it: the same weights as a scalar's.
vec3 faceShares(Face face) {
  const real3 weight =
      max(real3(crossed(face.b, face.c), crossed(face.c, face.a), crossed(face.a, face.b)), real3(0.0));
  const real area = weight.x + weight.y + weight.z;
  return area > kNoArea ? vec3(weight / area) : vec3(1.0, 0.0, 0.0);
}

vec3 faceGradient(Face face) {
  const vec3 share = faceShares(face);
  return share.x * vertexGradient(face.a.vertex) + share.y * vertexGradient(face.b.vertex) +
         share.z * vertexGradient(face.c.vertex);
}

// Along the cell's own gradient, any length: the sum over the faces of their area vectors times the scalar opposite.
vec3 cellGradient(MeshAddresses mesh, uint cell) {
  const Cell c = loadCell(mesh, cell);
  const vec3 a = c.position[1] - c.position[0];
  const vec3 b = c.position[2] - c.position[0];
  const vec3 d = c.position[3] - c.position[0];
  const vec3 rise = c.scalar.yzw - c.scalar.x;
  const vec3 sum = rise.x * cross(b, d) + rise.y * cross(d, a) + rise.z * cross(a, b);
  return dot(a, cross(b, d)) < 0.0 ? -sum : sum;
}

// Composites a surface behind light and opacity.
//   enter, leave   faces of the cell through which the ray passes
//   share          of the way between them
void addSurface(int surface, bool rising, MeshAddresses mesh, uint cell, Face enter, Face leave, float share, vec3 toEye,
                inout vec3 light, inout float opacity, inout float clearness) {
  const int texel = int(kSurfaceTexel + uint(surface) * APPEARANCE_SURFACE_TEXELS);
  const vec4 front = texelFetch(appearanceTexels, texel);
  const vec4 back = texelFetch(appearanceTexels, texel + 1);
  vec3 color = rising ? front.rgb : back.rgb;
  if (back.w != float(SHADING_NONE)) {
    vec3 normal;
    if (back.w == float(SHADING_PHONG))
      normal = mix(faceGradient(enter), faceGradient(leave), share);
    else
      normal = cellGradient(mesh, cell);
    const Illumination lit = illuminate(normal, toEye);
    color = color * lit.factor + lit.highlight;
  }
  const float transmittance = kEmissionPerLength ? clearness : 1.0 - opacity;
  light += transmittance * front.w * color;
  clearness *= 1.0 - front.w;
  opacity = front.w == 1.0 ? 1.0 : opacity + (1.0 - opacity) * front.w;
}
