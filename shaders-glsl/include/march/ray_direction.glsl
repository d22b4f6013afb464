// Where a pixel's ray goes.
//
// Before including: view_space.glsl.

// The ray's direction and, in an orthographic view, its place beside the eye, in view space; depths count along z.
vec3 screenPlace(FrameView view, uvec2 pixel) {
  return vec3((float(pixel.x) + 0.5 - view.halfSize.x) / view.pixelsPerUnit,
              (view.halfSize.y - float(pixel.y) - 0.5) / view.pixelsPerUnit, 1.0);
}

// Towards the eye, mesh space, unit length.
vec3 directionToEye(FrameView view, uvec2 pixel) {
  const vec3 forward = view.viewFromMesh[2].xyz;
  if (!kPerspective) return -forward;
  const vec3 screen = screenPlace(view, pixel);
  return -normalize(screen.x * view.viewFromMesh[0].xyz + screen.y * view.viewFromMesh[1].xyz + forward);
}
