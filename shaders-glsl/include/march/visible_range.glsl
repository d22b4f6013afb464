// The part of a ray that shows: in front of the eye, within all clip planes, before the nearest opaque surface.
//
// Before including: ray_signs.glsl, ray_direction.glsl, appearance_texels.glsl; RAY_ENDS is a binding number.
layout(constant_id = SPEC_RAY_ENDS) const bool kRayEnds = false;

layout(binding = RAY_ENDS) uniform samplerBuffer rayEnds;  // per pixel of the band: rgb of the opaque surface, depth from the mesh's centre

struct VisibleRange {
  real begin, end;  // depths from the mesh's centre
};

VisibleRange visibleRange(FrameView view, Ray ray, uvec2 pixel, uint bandPixel) {
  VisibleRange range = VisibleRange(ray.eyeDepth, real(1e30));
  const vec3 screen = screenPlace(view, pixel);
  for (uint i = 0; i < kClipPlanes; i++) {
    const vec4 plane = texelFetch(appearanceTexels, int(i));
    const float atEye = plane.w + (kPerspective ? 0.0 : dot(plane.xy, screen.xy));
    const float perDepth = kPerspective ? dot(plane.xyz, screen) : plane.z;
    // In a plane's own direction, all of the ray or nothing.
    const real crossing = perDepth != 0.0 ? ray.eyeDepth - real(atEye / perDepth) : real(atEye >= 0.0 ? -1e30 : 1e30);
    if (perDepth >= 0.0)
      range.begin = max(range.begin, crossing);
    else
      range.end = min(range.end, crossing);
  }
  if (kRayEnds) range.end = min(range.end, real(texelFetch(rayEnds, int(bandPixel)).w));
  return range;
}
