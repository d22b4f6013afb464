// A ray's walk through a mesh from face to face (after Weiler, Kraus, Merz and Ertl 2003, and Espinha and Celes 2005, but
// without plane equations).
//
// Seen along the ray (ray_signs.glsl), the origin lies in the projected triangle of the current face. The next cell adds one vertex P, and the
// origin lies in one of the three triangles that P makes with the current one's edges: that is the face where the ray leaves. All faces and
// cells around an edge take the same sign for it, and the walk is right for the mesh with its vertices rounded: it finds its way through
// slivers, flat cells and along edges.
//
// Before including: TOPOLOGY_ACROSS and MESH_VERTEX_RESTS are binding numbers; real.glsl, mesh_access.glsl and view_space.glsl.

#include "include/ray_signs.glsl"
#include "include/face_meeting.glsl"

// What lies across the face opposite a cell's k-th vertex in ascending order, at 4 cell + k: the cell there, or NO_CELL, and the
// vertex of it that the face does not have. So a step reads two numbers of the topology and four of the new vertex, one after
// the other.
layout(binding = TOPOLOGY_ACROSS) uniform usamplerBuffer topologyAcross;
#include "include/across_pieces.glsl"

// What single precision leaves of a vertex' position; used when REAL_IS_DOUBLE.
layout(binding = MESH_VERTEX_RESTS) uniform samplerBuffer meshVertexRests;
layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer VertexRestsAt { vec4 data[]; };

const uint NO_CELL = 0xffffffffu;

Vertex loadWalkVertex(MeshAddresses mesh, VertexRestsAt restsAt, uint index) {
  const vec4 v = loadVertex(mesh, index);
#ifdef REAL_IS_DOUBLE
  const vec4 rest = kWideAddressing ? restsAt.data[index] : texelFetch(meshVertexRests, int(index));
  return Vertex(index, real3(v.xyz) + real3(rest.xyz), v.w);
#else
  return Vertex(index, v.xyz, v.w);
#endif
}

Corner loadCorner(MeshAddresses mesh, VertexRestsAt restsAt, Ray ray, uint index) {
  return seenCorner(ray, loadWalkVertex(mesh, restsAt, index));
}

#ifdef REAL_IS_DOUBLE
// The point nearest to the ray on the longest edge of a face that is seen edge-on: the face is a line there, and any of its points
// above that place is on the ray.
Place onLongestEdge(Face face) {
  const real ab = dot(face.b.place - face.a.place, face.b.place - face.a.place);
  const real bc = dot(face.c.place - face.b.place, face.c.place - face.b.place);
  const real ca = dot(face.a.place - face.c.place, face.a.place - face.c.place);
  Corner from = face.a;
  Corner to = face.b;
  if (bc > max(ab, ca)) {
    from = face.b;
    to = face.c;
  } else if (ca > ab) {
    from = face.c;
    to = face.a;
  }
  const real2 edge = to.place - from.place;
  const real share = clamp(-dot(from.place, edge) / max(dot(edge, edge), kNoArea), real(0.0), real(1.0));
  return Place(mix(from.depth, to.depth, share), mix(from.scalar, to.scalar, float(share)));
}
#endif

// Where the ray leaves a cell. It does not go back. Places are rounded, so twice an area by that times the distances of the corners;
// where a face's area is not larger, the ray may as well run in the face as through it, and its weights tell nothing. In single
// precision it then stays where it entered, and the cell behind gets the whole way.
Place meetNext(Face face, Place entered) {
  const Meeting m = meeting(face);
  const real2 spread = abs(face.a.place) + abs(face.b.place) + abs(face.c.place);
  const bool isThrough = m.area > kPlaceRounding * (spread.x + spread.y);
  Place there = m.there;
#ifdef REAL_IS_DOUBLE
  if (!isThrough) there = onLongestEdge(face);
  if (there.depth > entered.depth) return there;
#else
  if (isThrough && there.depth > entered.depth) return there;
#endif
  return entered;
}

// A face of a cell as one number: 4 cell + the index of the vertex that the face does not have.
uint cellFace(MeshAddresses mesh, uint cell, uint opposite) {
  const uvec4 vertices = loadCellVertices(mesh, cell);
  return cell * 4u + (vertices.y == opposite ? 1u : vertices.z == opposite ? 2u : vertices.w == opposite ? 3u : 0u);
}

Face loadFace(MeshAddresses mesh, VertexRestsAt restsAt, Ray ray, uint code) {
  const uvec4 vertices = loadCellVertices(mesh, code >> 2);
  const uint k = code & 3u;
  const Corner a = loadCorner(mesh, restsAt, ray, k == 0u ? vertices.y : vertices.x);
  const Corner b = loadCorner(mesh, restsAt, ray, k <= 1u ? vertices.z : vertices.y);
  const Corner c = loadCorner(mesh, restsAt, ray, k <= 2u ? vertices.w : vertices.z);
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
uint crossCell(MeshAddresses mesh, VertexRestsAt restsAt, AcrossAt acrossAt, Ray ray, inout Behind at, inout Face face) {
  const Corner p = loadCorner(mesh, restsAt, ray, at.vertex);
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
  const uvec2 next = kWideAddressing ? acrossPiece(acrossAt, at.cell).data[acrossPlace(acrossAt, at.cell) + k]
                                     : texelFetch(topologyAcross, int(4u * at.cell + k)).xy;
  at = Behind(next.x, next.y);
  return replaced;
}
