// The visible part of a ray's segment in a cell.
//
// Before including: mesh_access.glsl, face_meeting.glsl, visible_range.glsl, classification.glsl.

struct VisibleSegment {
  float front, back;  // scalars
  float thickness;    // mesh units
  uint rank;          // of its middle, among all segments on the ray
  bool isVisible;     // not clipped altogether
  float hiddenFront, hiddenBack;  // shares of the way between the two faces
};

// The visible part of the segment between two faces.
VisibleSegment visibleSegment(MeshAddresses mesh, Ray ray, VisibleRange range, uint cell, Place enter, Place leave) {
  VisibleSegment segment = VisibleSegment(enter.scalar, leave.scalar, float(leave.depth - enter.depth), 0u, true, 0.0, 0.0);
  if (kCellField) segment.front = segment.back = loadCellScalar(mesh, cell);
  const float perThickness = 1.0 / max(segment.thickness, 1e-30);
  const float hiddenFront = clamp(float(range.begin - enter.depth) * perThickness, 0.0, 1.0);
  const float hiddenBack = clamp(float(leave.depth - range.end) * perThickness, 0.0, 1.0);
  const float visible = max(1.0 - hiddenFront - hiddenBack, 0.0);
  const float rise = segment.back - segment.front;
  // Ends that are faces keep the scalar that the next cell has, too.
  if (hiddenFront > 0.0) segment.front += hiddenFront * rise;
  if (hiddenBack > 0.0) segment.back -= hiddenBack * rise;
  segment.isVisible = visible > 0.0;
  segment.rank = depthRank(leave.depth - (hiddenBack + 0.5 * visible) * segment.thickness) | ENTRY_BIT;
  segment.thickness *= visible * ray.lengthPerDepth;
  segment.hiddenFront = hiddenFront;
  segment.hiddenBack = hiddenBack;
  return segment;
}

ClassifiedWalk beginClassified(VisibleSegment segment, Attributes enter, Attributes leave, vec3 toEye) {
  return ClassifiedWalk(segmentEnd(enter, leave, segment.hiddenFront, toEye),
                        segmentEnd(enter, leave, 1.0 - segment.hiddenBack, toEye), segment.front, segment.back,
                        segment.thickness, 0.0);
}
