// Which of two cells that share a face is in front.
//
// The eye lies on the positive or the negative side of the face's plane; the cell on the same side is in front. The sign
// is computed from the face's vertices in ascending order (as cells are stored), by the same operations whichever of the two
// cells asks, so both get the same answer. Where rounding could decide, there is no answer: the eye is in the face's plane
// as far as anyone can tell, and no ray of the picture passes through the face.
//
// Before including: TOPOLOGY_NEIGHBORS, TOPOLOGY_SIDES are binding numbers; mesh_access.glsl and view_space.glsl.
layout(binding = TOPOLOGY_NEIGHBORS) uniform usamplerBuffer topologyNeighbors;  // cell across face k, or NO_CELL
layout(binding = TOPOLOGY_SIDES) uniform usamplerBuffer topologySides;          // mesh/adjacency.h

layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer NeighborsAt { uvec4 data[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SidesAt { uint data[]; };  // four to a word

struct TopologyAddresses {
  NeighborsAt neighbors;
  SidesAt sides;
};

const uint NO_CELL = 0xffffffffu;

uvec4 loadNeighbors(TopologyAddresses topology, uint cell) {
  return kWideAddressing ? topology.neighbors.data[cell] : texelFetch(topologyNeighbors, int(cell));
}

uint loadSides(TopologyAddresses topology, uint cell) {
  return kWideAddressing ? (topology.sides.data[cell >> 2] >> (8u * (cell & 3u))) & 255u : texelFetch(topologySides, int(cell)).x;
}

// +1 or -1: the eye's side of the plane through a, b, c; 0: undecided.
int eyeSide(FrameView view, vec3 a, vec3 b, vec3 c) {
  precise const vec3 e = b - a;
  precise const vec3 f = c - a;
  precise const vec3 d = kPerspective ? view.eyeMesh.xyz - a : -view.viewFromMesh[2].xyz;
  precise const vec3 p = e.yzx * f.zxy;
  precise const vec3 q = e.zxy * f.yzx;
  precise const vec3 n = p - q;
  precise const float value = n.x * d.x + n.y * d.y + n.z * d.z;
  const float permanent = dot(abs(p) + abs(q), abs(d));
  const float bound = 6e-7 * permanent;  // ten roundings of 2^-24
  return value > bound ? 1 : value < -bound ? -1 : 0;
}

struct FaceOrder {
  bvec4 inFront;  // the cell across face k is in front of this one
  bvec4 behind;   // ... behind it; both for cells that overlap
  bool isEyeInside;  // the eye is certainly inside the cell
};

FaceOrder faceOrder(FrameView view, Cell cell, uint sides) {
  const ivec4 eye = ivec4(eyeSide(view, cell.position[1], cell.position[2], cell.position[3]),
                          eyeSide(view, cell.position[0], cell.position[2], cell.position[3]),
                          eyeSide(view, cell.position[0], cell.position[1], cell.position[3]),
                          eyeSide(view, cell.position[0], cell.position[1], cell.position[2]));
  FaceOrder order;
  order.isEyeInside = kPerspective;
  for (int k = 0; k < 4; k++) {
    const bool isPositive = ((sides >> k) & 1u) != 0u;
    const bool isFolded = ((sides >> (4 + k)) & 1u) != 0u;
    const bool isOwnSide = isPositive ? eye[k] > 0 : eye[k] < 0;
    order.isEyeInside = order.isEyeInside && eye[k] != 0 && isOwnSide;
    order.behind[k] = eye[k] != 0 && (isOwnSide || isFolded);
    order.inFront[k] = eye[k] != 0 && (!isOwnSide || isFolded);
  }
  return order;
}
