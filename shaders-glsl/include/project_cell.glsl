// A cell's projection and classification (Shirley and Tuchman 1990; Marroquim et al. 2008, section 4.1): once per cell in
// project/project.comp, once per vertex of what is drawn in raster/gator.vert.
//
// A cell's projection is a fan of triangles round its thick vertex, the point of the screen where a ray is longest inside the
// cell. Over each triangle the ray enters through one
// face and leaves through one other, so what is needed at both ends is linear on the screen: 1/depth and scalar/depth
// under perspective (Kraus, Qiao and Ebert 2004, section 2.2), depth and scalar otherwise. Every vertex carries
//
//     x   q of the front end,  q = 1/depth (perspective) or -depth (orthographic)
//     y   scalar of the front end, times q under perspective
//     z   q(front) - q(back) >= 0: a difference of its own, so that thin cells keep their digits
//     w   scalar of the back end, times q under perspective
//
// The signed screen areas A_i of the four faces (face i is opposite vertex i, all four oriented outwards) sum to zero.
// Faces of one sign face the eye, those of the other face away. With A+ the positive and A- the negative ones,
//
//     sum A+_i v_i / sum A+_i    and    sum |A-_i| v_i / sum |A-_i|
//
// are the two points of the cell at the thick vertex: they have the same screen position, and they are a vertex and a
// point of the opposite face (class 1), points of two opposite edges (class 2), or the limits of these when an area is
// zero (classes 3 and 4). The signs as a ternary number look up the order of the ring (truth_table.h).
//
// Before including: TRUTH_TABLE and LARGEST_EXTINCTIONS are binding numbers; `FrameView view`; include/mesh_access.glsl,
// include/view_space.glsl, shared/clipped_cells.h, shared/limits.h, shared/truth_table.h.

layout(binding = TRUTH_TABLE) uniform usamplerBuffer truthTable;                 // TRUTH_TABLE_SIZE entries
layout(binding = LARGEST_EXTINCTIONS) uniform samplerBuffer largestExtinctions;  // EXTINCTION_LEVELS x TRANSFER_BINS

layout(constant_id = SPEC_SILHOUETTE) const bool kSilhouette = false;

struct Fan {
  vec2 position[FAN_VERTICES];  // 0: centre, 1 to 4: ring; units of x/z or x,
                                // but ndc in what drawnCell() returns
  vec4 ends[FAN_VERTICES];
  uint triangles;
  bool isClipped;  // the ends are not those of a fan but the planes and scalars of clippedCell()
};

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Largest extinction between two scalars, from above: per mesh unit. With emission per length, of extinction and emission
// the larger: both are off by what the thickness is.
float largestExtinction(float low, float high) {
  const float last = float(TRANSFER_BINS - 1u);
  const int first = int(clamp((low + 0.5) * float(TRANSFER_BINS), 0.0, last));
  const int end = int(clamp((high + 0.5) * float(TRANSFER_BINS), 0.0, last));
  const int level = findMSB(end - first + 1);
  const int row = level * int(TRANSFER_BINS);
  return max(texelFetch(largestExtinctions, row + first).x, texelFetch(largestExtinctions, row + end + 1 - (1 << level)).x);
}

Fan projectCell(Cell cell, vec3 position[4]) {
  // Differences are taken between vertices before they are turned and projected: rounding is then relative to the cell's
  // size and not to its distance from the eye. delta(a, b) is the screen vector from vertex a to vertex b.
  vec2 screen[4];
  vec4 q;
  for (int i = 0; i < 4; i++) {
    q[i] = kPerspective ? 1.0 / position[i].z : -position[i].z;
    screen[i] = kPerspective ? position[i].xy * q[i] : position[i].xy;
  }
  vec3 edge[3];
  vec2 delta[3];
  vec4 dq = vec4(0.0);  // q relative to vertex 0
  for (int i = 0; i < 3; i++) {
    edge[i] = viewDirection(view, cell.position[i + 1] - cell.position[0]);
    delta[i] = kPerspective ? (edge[i].xy - screen[0] * edge[i].z) * q[i + 1] : edge[i].xy;
    dq[i + 1] = kPerspective ? -edge[i].z * q[0] * q[i + 1] : -edge[i].z;
  }
  vec2 delta1[2];
  for (int i = 0; i < 2; i++) {
    const vec3 e = viewDirection(view, cell.position[i + 2] - cell.position[1]);
    delta1[i] = kPerspective ? (e.xy - screen[1] * e.z) * q[i + 2] : e.xy;
  }
  const vec4 area = vec4(cross2(delta1[0], delta1[1]), -cross2(delta[1], delta[2]), cross2(delta[0], delta[2]),
                         -cross2(delta[0], delta[1]));

  // Heights of the four projected faces, pixels; each face of two of the edges from a common vertex.
  const float edge01 = dot(delta[0], delta[0]);
  const float edge02 = dot(delta[1], delta[1]);
  const float edge03 = dot(delta[2], delta[2]);
  const float edge12 = dot(delta1[0], delta1[0]);
  const float edge13 = dot(delta1[1], delta1[1]);
  const vec2 delta23 = delta1[1] - delta1[0];
  const float edge23 = dot(delta23, delta23);
  const vec4 longest = vec4(max(max(edge12, edge13), edge23), max(max(edge02, edge03), edge23),
                            max(max(edge01, edge03), edge13), max(max(edge01, edge02), edge12));
  // The two points at the thick vertex.
  const vec4 positive = max(area, vec4(0.0));
  const vec4 negative = max(-area, vec4(0.0));
  const vec4 weightA = positive / max(dot(positive, vec4(1.0)), 1e-37);
  const vec4 weightB = negative / max(dot(negative, vec4(1.0)), 1e-37);
  const vec4 sq = kPerspective ? cell.scalar * q : cell.scalar;
  const float dqA = dot(weightA, dq);
  const float dqB = dot(weightB, dq);
  const bool isFrontA = dqA >= dqB;
  const vec4 weightFront = isFrontA ? weightA : weightB;
  const vec4 weightBack = isFrontA ? weightB : weightA;

  const uvec4 ternary = uvec4(ivec4(sign(area)) + 1);
  const uint entry =
      texelFetch(truthTable, int(ternary.x * 27u + ternary.y * 9u + ternary.z * 3u + ternary.w)).x;
  Fan fan;
  const vec4 s = cell.scalar;
  const float extinction =
      largestExtinction(min(min(s.x, s.y), min(s.z, s.w)), max(max(s.x, s.y), max(s.z, s.w)));
  const float dqThick = abs(dqA - dqB);
  const float thickness = kPerspective ? dqThick / (dot(weightA, q) * dot(weightB, q)) : dqThick;
  const float height = EDGE_ON_HEIGHT * min(extinction * thickness, 1.0) / view.pixelsPerUnit;
  fan.isClipped = any(lessThan(area * area, longest * (height * height)));
  fan.triangles = truthTriangles(entry);
  const uint centreVertex = truthCentre(entry);
  fan.position[0] = centreVertex < 4u
                        ? screen[centreVertex]
                        : screen[0] * weightA.x + screen[1] * weightA.y + screen[2] * weightA.z + screen[3] * weightA.w;
  fan.ends[0] = vec4(dot(weightFront, q), dot(weightFront, sq), dqThick, dot(weightBack, sq));
  for (uint i = 0; i < 4u; i++) {
    const uint vertex = truthRing(entry, i);
    fan.position[i + 1u] = screen[vertex];
    fan.ends[i + 1u] = vec4(q[vertex], sq[vertex], 0.0, sq[vertex]);
  }
  if (fan.triangles == 0u) {  // no area
    for (int i = 0; i < FAN_VERTICES; i++) fan.position[i] = vec2(0.0);
  }
  return fan;
}

// A cell that is clipped: a rectangle that holds what can be seen of it. The ends are its faces' normals in view space, which
// point inwards, and its scalars, read by the fragment shader. Everything there is relative to vertex 0, so that the cell's
// distance from the eye costs no digits: face 0 carries its distance from that vertex (times its normal's length), the other
// three faces have none and carry the vertex instead.
Fan clippedCell(Cell cell, vec3 position[4], bool isNear) {
  ScreenBox box = pointsBox(view, position);
  if (isNear) box = nearCellBox(view, position);
  // One pixel more than the picture on every side: the rectangle's edges fall on no pixel centre.
  const vec2 low = max(box.low - 1.0, -view.halfSize - 1.0) / view.pixelsPerUnit;
  const vec2 high = min(box.high + 1.0, view.halfSize + 1.0) / view.pixelsPerUnit;
  Fan fan;
  fan.position[0] = 0.5 * (low + high);
  fan.position[1] = low;
  fan.position[2] = vec2(high.x, low.y);
  fan.position[3] = high;
  fan.position[4] = vec2(low.x, high.y);
  fan.triangles = 4u;
  fan.isClipped = true;

  // All oriented alike: the four distances below are the same number but for rounding, six times the volume, and its sign is one
  // for all four. Signs of their own would turn single faces of a cell whose volume is lost in rounding, and open it to infinity.
  vec3 normals[4];
  vec4 towards;
  const ivec3 faces[4] = ivec3[4](ivec3(1, 3, 2), ivec3(0, 2, 3), ivec3(0, 3, 1), ivec3(0, 1, 2));
  for (int i = 0; i < 4; i++) {
    // From the vertex opposite the longest edge: the product of the two shorter edges loses no digits.
    ivec3 face = faces[i];
    const vec3 a = cell.position[face.x], b = cell.position[face.y], c = cell.position[face.z];
    const vec3 opposite = vec3(dot(c - b, c - b), dot(a - c, a - c), dot(b - a, b - a));
    if (opposite.y >= opposite.x && opposite.y >= opposite.z)
      face = face.yzx;
    else if (opposite.z >= opposite.x)
      face = face.zxy;
    normals[i] = cross(cell.position[face.y] - cell.position[face.x], cell.position[face.z] - cell.position[face.x]);
    towards[i] = dot(normals[i], cell.position[i] - cell.position[face.x]);
  }
  const float orientation = sign(dot(towards, vec4(1.0)));
  for (int i = 0; i < 4; i++) {
    fan.ends[i].xyz = orientation * viewDirection(view, normals[i]);
    fan.ends[i].w = i == 0 ? orientation * towards[0] : position[0][max(i - 1, 0)];
  }
  fan.ends[4] = cell.scalar;
  return fan;
}

// Pixels by which outlines are larger than projections: then the rasteriser, which snaps vertices to 1/256 pixel, cannot cut
// anything off. Beside the cell the clipped segment is empty.
const float kOutlineMargin = 1.0 / 64.0;

// Pixel centres in a cell's box up to which it is drawn as these: one triangle around them instead of two that are hardly larger.
const float kFewPixels = 2.0;

// The right-angled triangle around all pixel centres from one on, and no others in its row and column.
//   first   the lower left one, pixels from the picture's middle
//   steps   columns and rows to the last
void drawPixels(inout Fan outline, vec2 first, vec2 steps) {
  const vec2 corner = first - 0.25;
  const vec2 legs = 2.0 * steps + 0.75;
  outline.position[1] = corner / view.pixelsPerUnit;
  outline.position[2] = vec2(corner.x + legs.x, corner.y) / view.pixelsPerUnit;
  outline.position[3] = vec2(corner.x, corner.y + legs.y) / view.pixelsPerUnit;
  outline.position[4] = outline.position[1];
  outline.triangles = 1u;
}

// A cell that is drawn as its outline, the fan's ring, and clipped (balanced projection: Moreland and Angel 2004; view-independent
// projection: Weiler, Kraus, Merz and Ertl 2003). Enlarged about its middle; what is too thin for that, and what is near, is drawn as
// a rectangle, and what is very small as its pixels.
Fan outlinedCell(Cell cell, vec3 position[4], Fan fan, bool isNear) {
  Fan outline = clippedCell(cell, position, isNear);
  const bool isQuad = fan.position[4] != fan.position[1];
  const vec2 middle = isQuad ? 0.25 * (fan.position[1] + fan.position[2] + fan.position[3] + fan.position[4])
                             : (fan.position[1] + fan.position[2] + fan.position[3]) / 3.0;
  float height = 1e30;  // of the middle above the outline's edges
  for (int i = 1; i <= 4; i++) {
    const vec2 edge = fan.position[i % 4 + 1] - fan.position[i];
    const float length2 = dot(edge, edge);
    if (length2 > 0.0) height = min(height, abs(cross2(edge, middle - fan.position[i])) * inversesqrt(length2));
  }
  const float margin = kOutlineMargin / view.pixelsPerUnit;
  const ScreenBox box = pointsBox(view, position);
  const vec2 first = ceil(box.low + view.halfSize - (0.5 + kOutlineMargin)) + 0.5 - view.halfSize;
  const vec2 steps = max(floor(box.high + kOutlineMargin - first), vec2(0.0));
  if (!isNear && (steps.x + 1.0) * (steps.y + 1.0) <= kFewPixels) {
    drawPixels(outline, first, steps);
  } else if (!isNear && fan.triangles > 0u && height < 1e30 && height > margin) {
    for (int i = 0; i < FAN_VERTICES; i++)
      outline.position[i] = middle + (fan.position[i] - middle) * (1.0 + margin / height);
    outline.triangles = isQuad ? 2u : 1u;
  } else {
    outline.triangles = 2u;
  }
  return outline;
}

// A cell as it is drawn: a fan, an outline or a rectangle. Positions are ndc.
Fan drawnCell(Cell cell) {
  vec3 position[4];
  for (int i = 0; i < 4; i++) position[i] = viewPosition(view, cell.position[i]);
  const bool isNear = isNearCell(vec4(position[0].z, position[1].z, position[2].z, position[3].z));
  Fan fan = projectCell(cell, position);
  if (kSilhouette)
    fan = outlinedCell(cell, position, fan, isNear);
  else if (isNear || fan.isClipped)
    fan = clippedCell(cell, position, isNear);
  const vec2 ndcPerUnit = view.pixelsPerUnit / view.halfSize;
  for (int i = 0; i < FAN_VERTICES; i++) fan.position[i] *= ndcPerUnit;
  return fan;
}
