// A pixel's ray and a triangle of an opaque surface, by the signs of ray_walk.glsl.
//
// Before including: shared/frame_view.h, shared/spec_ids.h, shared/pixel_lists.h; SURFACE_VERTICES is a binding number.
#include "include/real.glsl"
#include "include/view_space.glsl"
#include "include/ray_signs.glsl"

layout(binding = SURFACE_VERTICES) uniform samplerBuffer surfaceVertices;  // position in mesh space

struct TriangleMeeting {
  bool isMet;            // in front of the eye
  bool isAnticlockwise;  // as it is seen
  float depth;           // from the mesh's centre
  vec3 share;            // of its corners
};

Corner surfaceCorner(Ray ray, uint vertex) {
  return seenCorner(ray, Vertex(vertex, texelFetch(surfaceVertices, int(vertex)).xyz, 0.0));
}

TriangleMeeting meetTriangle(FrameView view, uvec2 pixel, uvec3 corners) {
  const Ray ray = pixelRay(view, pixel);
  const Corner a = surfaceCorner(ray, corners.x);
  const Corner b = surfaceCorner(ray, corners.y);
  const Corner c = surfaceCorner(ray, corners.z);
  const bool leftAB = isLeft(a, b);
  const bool isInside = leftAB == isLeft(b, c) && leftAB == isLeft(c, a);
  const vec3 weight = max(vec3(crossed(b, c), crossed(c, a), crossed(a, b)) * (leftAB ? 1.0 : -1.0), vec3(0.0));
  const float area = weight.x + weight.y + weight.z;
  const vec3 share = area > kNoArea ? weight / area : vec3(1.0, 0.0, 0.0);
  const float depth = dot(share, vec3(a.depth, b.depth, c.depth));
  return TriangleMeeting(isInside && area > 0.0 && depth > ray.eyeDepth, leftAB, depth, share);
}

// Depths as integers of the same order, whatever their sign.
uint depthOrder(float depth) {
  const uint bits = floatBitsToUint(depth);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}
