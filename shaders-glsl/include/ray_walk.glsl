// A ray's walk through a mesh from face to face (after Weiler, Kraus, Merz and Ertl 2003, and Espinha and Celes 2005, but
// without plane equations).
//
// Everything is seen along the ray: a vertex has a place (u, v) beside it, linear in the vertex's position, with the ray at the
// origin; there is no division, so a vertex beside or behind the eye needs no special case. The origin lies in the projected
// triangle of the current face. The next cell adds one vertex P, and the origin lies in one of the three triangles that P
// makes with the current one's edges: that is the face where the ray leaves. On which side of an edge the origin lies is
// computed from its two ends by the same operations whoever asks, so all faces and cells around an edge agree, and the walk is
// right for the mesh with its vertices rounded: it finds its way through slivers, flat cells and along edges.
//
// Where the origin is on an edge it is taken to be a little beside it, in the same direction for all edges (Edelsbrunner and
// Muecke 1990). An edge along the ray has no sides, and is in no triangle that the origin lies in.
//
// Before including: TOPOLOGY_ACROSS is a binding number; mesh_access.glsl and view_space.glsl.

// What lies across the face opposite a cell's k-th vertex in ascending order, at 4 cell + k: the cell there, or NO_CELL, and the
// vertex of it that the face does not have. So a step reads two numbers of the topology and four of the new vertex, one after
// the other.
layout(binding = TOPOLOGY_ACROSS) uniform usamplerBuffer topologyAcross;
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer AcrossAt { uvec2 data[]; };

const uint NO_CELL = 0xffffffffu;

struct Ray {
  vec4 u;            // u = dot(u.xyz, mesh position) + u.w
  vec4 v;
  vec3 forward;      // depth from the mesh's centre = dot(forward, mesh position)
  float eyeDepth;    // where the ray starts
  float lengthPerDepth;
};

// The ray through a pixel's centre.
//   pixel   column, and row from the top
Ray pixelRay(FrameView view, uvec2 pixel) {
  const vec2 screen = vec2(float(pixel.x) + 0.5 - view.halfSize.x, view.halfSize.y - float(pixel.y) - 0.5) / view.pixelsPerUnit;
  Ray ray;
  ray.forward = view.viewFromMesh[2].xyz;
  ray.eyeDepth = -view.viewFromMesh[2].w;
  precise vec4 u = view.viewFromMesh[0];
  precise vec4 v = view.viewFromMesh[1];
  if (kPerspective) {
    u -= screen.x * view.viewFromMesh[2];
    v -= screen.y * view.viewFromMesh[2];
  } else {
    u.w -= screen.x;
    v.w -= screen.y;
  }
  ray.u = u;
  ray.v = v;
  ray.lengthPerDepth = kPerspective ? sqrt(1.0 + dot(screen, screen)) : 1.0;
  return ray;
}

// A vertex, seen along the ray.
struct Corner {
  uint vertex;
  vec2 place;  // (u, v)
  float depth;
  float scalar;
};

//   p   position in mesh space, scalar
Corner seenCorner(Ray ray, uint vertex, vec4 p) {
  precise const float u = (ray.u.x * p.x + ray.u.y * p.y) + (ray.u.z * p.z + ray.u.w);
  precise const float v = (ray.v.x * p.x + ray.v.y * p.y) + (ray.v.z * p.z + ray.v.w);
  return Corner(vertex, vec2(u, v), dot(ray.forward, p.xyz), p.w);
}

Corner loadCorner(MeshAddresses mesh, Ray ray, uint vertex) { return seenCorner(ray, vertex, loadVertex(mesh, vertex)); }

// Twice the signed area of the triangle of the origin, a and b. Exchanging a and b negates it exactly.
float crossed(Corner a, Corner b) {
  precise const float left = a.place.x * b.place.y;
  precise const float right = a.place.y * b.place.x;
  precise const float area = left - right;
  return area;
}

// Whether the origin lies to the left of the edge from a to b.
bool isLeft(Corner a, Corner b) {
  // The origin's place is (1e-20, 1e-27): areas that are not zero are far larger, products of roundings of 2^-23.
  precise const vec2 edge = a.place - b.place;
  precise const float beside = edge.y * 1e-20 - edge.x * 1e-27;
  return crossed(a, b) + beside > 0.0;
}

// A face; the ray sees its corners anticlockwise.
struct Face {
  Corner a, b, c;
};

// Where the ray meets a face: a convex combination of the corners, whatever the rounding.
struct Meeting {
  vec2 there;   // depth, and scalar
  float area;   // of the projected face, twice
};

Meeting meeting(Face face) {
  const vec3 weight =
      max(vec3(crossed(face.b, face.c), crossed(face.c, face.a), crossed(face.a, face.b)), vec3(0.0));
  const float area = weight.x + weight.y + weight.z;
  const float depth = weight.x * face.a.depth + weight.y * face.b.depth + weight.z * face.c.depth;
  const float scalar = weight.x * face.a.scalar + weight.y * face.b.scalar + weight.z * face.c.scalar;
  const float inverse = 1.0 / max(area, 1e-37);
  return Meeting(area > 1e-37 ? vec2(depth, scalar) * inverse : vec2(face.a.depth, face.a.scalar), area);
}

// Depths as integers of the same order, without the last bit. They are within 1.8 of the mesh's centre: what is compared is positive.
uint depthRank(float depth) { return floatBitsToUint(depth + 4.0) & ~ENTRY_BIT; }

vec2 meetFirst(Face face) { return meeting(face).there; }

// Places are rounded by some 2^-23, so twice an area by that times the distances of the corners. Where a face's area is
// not larger, the ray may as well run in the face as through it, and where they meet cannot be told.
const float kAlongRay = 1e-6;

// Depth and scalar where the ray leaves a cell. It does not go back; for a face along the ray it stays where it entered, and the
// cell behind gets the whole way.
vec2 meetNext(Face face, vec2 entered) {
  const Meeting m = meeting(face);
  const vec2 spread = abs(face.a.place) + abs(face.b.place) + abs(face.c.place);
  return m.area > kAlongRay * (spread.x + spread.y) && m.there.x > entered.x ? m.there : entered;
}

// A face of a cell as one number: 4 cell + the index of the vertex that the face does not have.
uint cellFace(MeshAddresses mesh, uint cell, uint opposite) {
  const uvec4 vertices = loadCellVertices(mesh, cell);
  return cell * 4u + (vertices.y == opposite ? 1u : vertices.z == opposite ? 2u : vertices.w == opposite ? 3u : 0u);
}

Face loadFace(MeshAddresses mesh, Ray ray, uint code) {
  const uvec4 vertices = loadCellVertices(mesh, code >> 2);
  const uint k = code & 3u;
  const Corner a = loadCorner(mesh, ray, k == 0u ? vertices.y : vertices.x);
  const Corner b = loadCorner(mesh, ray, k <= 1u ? vertices.z : vertices.y);
  const Corner c = loadCorner(mesh, ray, k <= 2u ? vertices.w : vertices.z);
  Face face = Face(a, b, c);
  if (!isLeft(a, b)) face = Face(a, c, b);
  return face;
}

// A cell that a ray has entered through a face.
struct Behind {
  uint cell;    // or NO_CELL
  uint vertex;  // of it, that the face does not have
};

// The cell behind the face with that code.
Behind behindFace(MeshAddresses mesh, uint code) {
  const uvec4 vertices = loadCellVertices(mesh, code >> 2);
  const uint k = code & 3u;
  return Behind(code >> 2, k == 0u ? vertices.x : k == 1u ? vertices.y : k == 2u ? vertices.z : vertices.w);
}

// Moves the face through a cell to where the ray leaves it, and the cell to the one behind. Returns the vertex of the cell that was
// crossed which the face between the two does not have.
uint crossCell(MeshAddresses mesh, AcrossAt acrossAt, Ray ray, inout Behind at, inout Face face) {
  const Corner p = loadCorner(mesh, ray, at.vertex);
  const bool leftA = isLeft(p, face.a);
  const bool leftB = isLeft(p, face.b);
  const bool leftC = isLeft(p, face.c);
  // The vertex that P replaces. All three alike is what no point can see, but rounding next to P can; any face will do then.
  const bool replacesA = leftB && !leftC;
  const bool replacesB = leftC && !leftA;
  const uint replaced = replacesA ? face.a.vertex : replacesB ? face.b.vertex : face.c.vertex;
  if (replacesA)
    face.a = p;
  else if (replacesB)
    face.b = p;
  else
    face.c = p;
  const uint k = uint(face.a.vertex < replaced) + uint(face.b.vertex < replaced) + uint(face.c.vertex < replaced);
  const uint across = 4u * at.cell + k;
  const uvec2 next = kWideAddressing ? acrossAt.data[across] : texelFetch(topologyAcross, int(across)).xy;
  at = Behind(next.x, next.y);
  return replaced;
}
