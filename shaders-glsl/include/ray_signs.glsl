// A ray, and on which side of it things lie.
//
// Everything is seen along the ray: a vertex has a place (u, v) beside it, linear in the vertex's position, with the ray at the
// origin; there is no division, so a vertex beside or behind the eye needs no special case. On which side of an edge the origin lies is
// computed from its two ends by the same operations whoever asks, so all faces around an edge agree.
//
// Where the origin is on an edge it is taken to be a little beside it, in the same direction for all edges (Edelsbrunner and
// Muecke 1990). An edge along the ray has no sides, and is in no triangle that the origin lies in.
//
// Before including: real.glsl and view_space.glsl.

struct Ray {
  real4 u;            // u = dot(u.xyz, mesh position) + u.w
  real4 v;
  real3 forward;      // depth from the mesh's centre = dot(forward, mesh position)
  real eyeDepth;      // where the ray starts
  float lengthPerDepth;
};

real4 viewRow(FrameView view, int row) {
#ifdef REAL_IS_DOUBLE
  return real4(view.viewFromMesh[row]) + real4(view.viewFromMeshRest[row]);
#else
  return view.viewFromMesh[row];
#endif
}

real pixelsPerUnit(FrameView view) {
#ifdef REAL_IS_DOUBLE
  return real(view.pixelsPerUnit) + real(view.pixelsPerUnitRest);
#else
  return view.pixelsPerUnit;
#endif
}

// The ray through a pixel's centre.
//   pixel   column, and row from the top
Ray pixelRay(FrameView view, uvec2 pixel) {
  const vec2 fromCenter = vec2(float(pixel.x) + 0.5 - view.halfSize.x, view.halfSize.y - float(pixel.y) - 0.5);
  const real2 screen = real2(fromCenter) / pixelsPerUnit(view);
  const real4 forward = viewRow(view, 2);
  Ray ray;
  ray.forward = forward.xyz;
  ray.eyeDepth = -forward.w;
  precise real4 u = viewRow(view, 0);
  precise real4 v = viewRow(view, 1);
  if (kPerspective) {
    u -= screen.x * forward;
    v -= screen.y * forward;
  } else {
    u.w -= screen.x;
    v.w -= screen.y;
  }
  ray.u = u;
  ray.v = v;
  ray.lengthPerDepth = kPerspective ? sqrt(1.0 + float(dot(screen, screen))) : 1.0;
  return ray;
}

// A vertex: where it is in mesh space, and its scalar.
struct Vertex {
  uint index;
  real3 position;
  float scalar;
};

// A vertex, seen along the ray.
struct Corner {
  uint vertex;
  real2 place;  // (u, v)
  real depth;
  float scalar;
};

Corner seenCorner(Ray ray, Vertex vertex) {
  const real3 p = vertex.position;
  precise const real u = (ray.u.x * p.x + ray.u.y * p.y) + (ray.u.z * p.z + ray.u.w);
  precise const real v = (ray.v.x * p.x + ray.v.y * p.y) + (ray.v.z * p.z + ray.v.w);
  return Corner(vertex.index, real2(u, v), dot(ray.forward, p), vertex.scalar);
}

// Twice the signed area of the triangle of the origin, a and b. Exchanging a and b negates it exactly.
real crossed(Corner a, Corner b) {
  precise const real left = a.place.x * b.place.y;
  precise const real right = a.place.y * b.place.x;
  precise const real area = left - right;
  return area;
}

// Whether the origin lies to the left of the edge from a to b.
bool isLeft(Corner a, Corner b) {
  // The origin's place is kBesideEdge: areas that are not zero are far larger, products of roundings.
  precise const real2 edge = a.place - b.place;
  precise const real beside = edge.y * kBesideEdge.x - edge.x * kBesideEdge.y;
  return crossed(a, b) + beside > 0.0;
}
