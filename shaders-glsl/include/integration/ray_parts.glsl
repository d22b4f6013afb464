// The exact method along a whole ray: as in exact.glsl, but scalar and optics at the place that the walk has come to are kept from
// part to part and from cell to cell, because they are continuous there. A part then needs only the control point that it runs
// towards: five numbers instead of thirteen.
//
// Optics are interpolated from where the ray is to the control point ahead. That is a convex combination, so roundings fade
// instead of growing, and at a control point they are gone.
//
// Before including: exact.glsl, and the binding numbers TRANSFER_POINTS and TRANSFER_POINT_SCALARS. With APPEARANCE defined, kIsosurfaces
// and kVolume: control points may be isosurfaces, and the volume between them may be left out.

// Control points in ascending order; a step is two of the same scalar. The first and the last are at -1e30 and 1e30.
layout(binding = TRANSFER_POINTS) uniform samplerBuffer transferPoints;              // luminance, extinction
// Texel i: the scalars of points i and i + 1; with APPEARANCE the isosurfaces at them, too, or -1.
layout(binding = TRANSFER_POINT_SCALARS) uniform samplerBuffer transferPointScalars;

struct RayParts {
  float scalar;     // where the ray is
  float back;       // at the end of the cell
  float thickness;  // from here to there, mesh units
  vec4 optics;      // luminance, extinction here
  int interval;     // between control points i and i + 1
#ifdef APPEARANCE
  vec4 ends;        // their scalars, and the isosurfaces there, or -1
  float surface;    // isosurface at which the last part ended, or -1
  bool rising;      // towards it
#else
  vec2 ends;        // their scalars: fetched early, because which cell comes next waits for them
#endif
};

// Index of the last control point that is not above a scalar.
int intervalOf(float scalar) {
  int low = 0;
  int high = textureSize(transferPointScalars);
  for (int round = 0; round < 32; round++) {
    if (high - low <= 1) break;
    const int middle = (low + high) / 2;
    const bool isBehind = texelFetch(transferPointScalars, middle).x <= scalar;
    low = isBehind ? middle : low;
    high = isBehind ? high : middle;
  }
  return low;
}

RayParts beginRay(float scalar, float back, float thickness) {
#ifdef APPEARANCE
  RayParts ray = RayParts(scalar, back, thickness, vec4(0.0), intervalOf(scalar), vec4(0.0), -1.0, false);
#else
  RayParts ray = RayParts(scalar, back, thickness, vec4(0.0), intervalOf(scalar), vec2(0.0));
#endif
#ifdef APPEARANCE
  ray.ends = texelFetch(transferPointScalars, ray.interval);
#else
  ray.ends = texelFetch(transferPointScalars, ray.interval).xy;
#endif
  ray.optics = mix(texelFetch(transferPoints, ray.interval), texelFetch(transferPoints, ray.interval + 1),
                   clamp((scalar - ray.ends.x) / (ray.ends.y - ray.ends.x), 0.0, 1.0));
  return ray;
}

// Composites the next part behind light and opacity. Returns whether it was the cell's last one.
//   clearness   with emission per length: the transmittance so far, 1 at first
bool walkRayPart(inout RayParts ray, inout vec3 light, inout float opacity, inout float clearness) {
  const float rise = ray.back - ray.scalar;
  const bool rising = rise >= 0.0;
  const int ahead = rising ? ray.interval + 1 : ray.interval;
  const float scalarAhead = rising ? ray.ends.y : ray.ends.x;
  const vec4 opticsAhead = texelFetch(transferPoints, ahead);

  // A cell of one scalar, on a control point: what comes after it counts.
#ifdef APPEARANCE
  // A surface's side that scalars on it belong to is the one above.
  const bool isLast = rising ? scalarAhead > ray.back : scalarAhead <= ray.back;
#else
  const bool isLast = rising ? (rise > 0.0 ? scalarAhead >= ray.back : scalarAhead > ray.back) : scalarAhead <= ray.back;
#endif
  const float toAhead = scalarAhead - ray.scalar;
  const float whole = isLast ? toAhead : rise;
  const float quotient = whole == 0.0 ? 0.0 : clamp((isLast ? rise : toAhead) / whole, 0.0, 1.0);
  float towards = isLast ? quotient : 1.0;             // share of the way to the control point
  float part = (isLast ? 1.0 : quotient) * ray.thickness;

  const vec4 change = opticsAhead - ray.optics;
#ifdef APPEARANCE
  const float keep = kVolume ? keptShare(ray.optics.w, ray.optics.w + towards * change.w, part) : 1.0;
#else
  const float keep = keptShare(ray.optics.w, ray.optics.w + towards * change.w, part);
#endif
  const bool isCut = keep < 1.0;
  towards *= keep;
  part *= keep;
  const vec4 risen = towards * change;
  const float extinctionBack = ray.optics.w + risen.w;
#ifdef APPEARANCE
  ray.surface = isCut || isLast ? -1.0 : rising ? ray.ends.w : ray.ends.z;
  ray.rising = rising;
  if (kVolume)
#endif
    addPart(ray.optics.w, extinctionBack, ray.optics.xyz, risen.xyz, part, light, opacity, clearness);

  ray.optics += risen;
  ray.scalar = isCut ? ray.scalar + towards * toAhead : isLast ? ray.back : scalarAhead;
  ray.thickness -= part;
  if (!isCut && !isLast) ray.interval = rising ? ray.interval + 1 : ray.interval - 1;
#ifdef APPEARANCE
  ray.ends = texelFetch(transferPointScalars, ray.interval);
#else
  ray.ends = texelFetch(transferPointScalars, ray.interval).xy;
#endif
  return isLast && !isCut;
}
