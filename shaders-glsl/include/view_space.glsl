// From mesh space to the screen.
layout(constant_id = SPEC_PERSPECTIVE) const bool kPerspective = true;
layout(constant_id = SPEC_NEAR_CELLS) const bool kNearCells = false;

vec3 viewDirection(FrameView view, vec3 direction) {
  return vec3(dot(view.viewFromMesh[0].xyz, direction), dot(view.viewFromMesh[1].xyz, direction),
              dot(view.viewFromMesh[2].xyz, direction));
}

vec3 viewPosition(FrameView view, vec3 position) {
  return viewDirection(view, position) +
         vec3(view.viewFromMesh[0].w, view.viewFromMesh[1].w, view.viewFromMesh[2].w);
}

// shared/clipped_cells.h
bool isNearCell(vec4 depth) {
  const float nearest = min(min(depth.x, depth.y), min(depth.z, depth.w));
  const float farthest = max(max(depth.x, depth.y), max(depth.z, depth.w));
  return kNearCells && (kPerspective ? nearest < farthest * NEAR_DEPTH_RATIO : nearest < 0.0);
}

// Pixels, from the image's centre.
struct ScreenBox {
  vec2 low;
  vec2 high;
};

ScreenBox pointsBox(FrameView view, vec3 position[4]) {
  ScreenBox box = ScreenBox(vec2(1e30), vec2(-1e30));
  for (int i = 0; i < 4; i++) {
    const vec2 screen = position[i].xy * (view.pixelsPerUnit / (kPerspective ? position[i].z : 1.0));
    box.low = min(box.low, screen);
    box.high = max(box.high, screen);
  }
  return box;
}

// The box of what lies in front of the eye, for a near cell with at least one vertex there. Points closer than a
// fraction of the cell's own depth are cut off: they are on every ray from the eye or on none that can be seen.
ScreenBox nearCellBox(FrameView view, vec3 position[4]) {
  if (!kPerspective) return pointsBox(view, position);
  ScreenBox box = ScreenBox(vec2(1e30), vec2(-1e30));
  const float farthest = max(max(position[0].z, position[1].z), max(position[2].z, position[3].z));
  const float cut = farthest * 1e-6;
  for (int i = 0; i < 4; i++) {
    for (int j = 0; j < 4; j++) {
      if (position[i].z < cut) continue;
      // j behind the cut: the edge's point on it; otherwise the vertex itself.
      const float t = position[j].z < cut ? (position[i].z - cut) / (position[i].z - position[j].z) : 0.0;
      const vec3 p = mix(position[i], position[j], t);
      const vec2 screen = p.xy * (view.pixelsPerUnit / max(p.z, cut));
      box.low = min(box.low, screen);
      box.high = max(box.high, screen);
    }
  }
  return box;
}
