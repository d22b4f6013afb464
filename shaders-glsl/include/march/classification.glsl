// Classification by more than the scalar (docs/appearance.md): numbers at vertices, and what depends on the direction of view, are linear along a
// ray's segment, so extinction and luminance are products of linear functions between the places where one of them meets a point of its curve.
// Segments are split exactly there. What is left is curved; it is walked in parts on which it hardly is, and each part gets the mean of
// its curve (Simpson), so that linear integration does for any classification (Moreland and Angel 2004, section 3.2).
//
// Before including: ray_parts.glsl, ray_walk.glsl, illumination.glsl, isosurface.glsl; VERTEX_NUMBERS and VERTEX_COLORS are binding numbers.
layout(constant_id = SPEC_CLASSIFIED) const bool kClassified = false;
layout(constant_id = SPEC_LIT_VOLUME) const bool kLitVolume = false;
layout(constant_id = SPEC_VERTEX_COLORS) const bool kVertexColors = false;
// Columns (scalars) and rows (gradients) of a transfer function of two dimensions; 0: there is none.
layout(constant_id = SPEC_TRANSFER_COLUMNS) const uint kTransferColumns = 0;
layout(constant_id = SPEC_TRANSFER_ROWS) const uint kTransferRows = 0;

layout(binding = VERTEX_NUMBERS) uniform samplerBuffer vertexNumbers;  // gradient's length, boundary distance, second field: normalised
layout(binding = VERTEX_COLORS) uniform samplerBuffer vertexColors;    // luminance, extinction

const bool kUsesGradient = kLitVolume || kCosinePoints > 0u;
const bool kUsesNumbers = kMagnitudePoints + kBoundaryPoints + kFieldPoints + kTransferColumns > 0u;
const uint kBoundaryCurve = kMagnitudePoints;
const uint kFieldCurve = kBoundaryCurve + kBoundaryPoints;
const uint kCosineCurve = kFieldCurve + kFieldPoints;
const uint kCurvePoints = kCosineCurve + kCosinePoints;

// How far extinction times length, or luminance times opacity, of a part may be from linear at its middle.
const float kLargestBend = 2e-3;
const float kLeastShare = 1e-3;  // of a segment in a part

struct Attributes {
  vec3 gradient;
  vec3 numbers;
  vec4 color;
};

Attributes vertexAttributes(uint vertex) {
  Attributes result = Attributes(vec3(0.0), vec3(0.0), vec4(0.0));
  if (kUsesGradient) result.gradient = vertexGradient(vertex);
  if (kUsesNumbers) result.numbers = texelFetch(vertexNumbers, int(vertex)).xyz;
  if (kVertexColors) result.color = texelFetch(vertexColors, int(vertex));
  return result;
}

Attributes faceAttributes(Face face) {
  const vec3 share = faceShares(face);
  const Attributes a = vertexAttributes(face.a.vertex);
  const Attributes b = vertexAttributes(face.b.vertex);
  const Attributes c = vertexAttributes(face.c.vertex);
  return Attributes(share.x * a.gradient + share.y * b.gradient + share.z * c.gradient,
                    share.x * a.numbers + share.y * b.numbers + share.z * c.numbers,
                    share.x * a.color + share.y * b.color + share.z * c.color);
}

// What a segment has at one of its ends; all linear in between.
struct SegmentEnd {
  vec4 numbers;  // and the cosine between gradient and ray
  vec4 color;
  Illumination light;
};

SegmentEnd segmentEnd(Attributes a, Attributes b, float share, vec3 toEye) {
  const vec3 gradient = mix(a.gradient, b.gradient, share);
  SegmentEnd end = SegmentEnd(vec4(mix(a.numbers, b.numbers, share), 0.0), mix(a.color, b.color, share),
                              Illumination(vec3(1.0), vec3(0.0)));
  if (kCosinePoints > 0u) end.numbers.w = dot(facingNormal(gradient, toEye), toEye);
  if (kLitVolume) end.light = illuminate(gradient, toEye);
  return end;
}

struct ClassifiedWalk {
  SegmentEnd front, back;
  float scalarFront, scalarBack;
  float thickness;  // of the segment, mesh units
  float share;      // of it that has been walked
};

// The nearest share of the segment beyond which a number meets a point of its curve, if nearer than `nearest`.
float nextPoint(uint curve, uint points, float front, float back, float share, float nearest) {
  const float perNumber = front == back ? 0.0 : 1.0 / (back - front);
  for (uint i = 0; i < points; i++) {
    const float at = (texelFetch(appearanceTexels, int(kCurveTexel + 2u * (curve + i))).x - front) * perNumber;
    if (at > share) nearest = min(nearest, at);
  }
  return nearest;
}

// The factors of luminance (rgb) and extinction (a) at both ends of a part that holds no point of the curve inside.
void curveFactors(uint curve, uint points, float front, float back, out vec4 atFront, out vec4 atBack) {
  const float middle = 0.5 * (front + back);
  uint after = 0;  // the first point beyond the part
  for (uint i = 0; i < points; i++) {
    if (texelFetch(appearanceTexels, int(kCurveTexel + 2u * (curve + i))).x <= middle) after = i + 1u;
  }
  const int low = int(kCurveTexel + 2u * (curve + max(after, 1u) - 1u));
  const int high = int(kCurveTexel + 2u * (curve + min(after, points - 1u)));
  const vec4 factorLow = texelFetch(appearanceTexels, low + 1);
  const vec4 factorHigh = texelFetch(appearanceTexels, high + 1);
  const float valueLow = texelFetch(appearanceTexels, low).x;
  const float width = texelFetch(appearanceTexels, high).x - valueLow;
  const float perWidth = width > 0.0 ? 1.0 / width : 0.0;
  atFront = mix(factorLow, factorHigh, clamp((front - valueLow) * perWidth, 0.0, 1.0));
  atBack = mix(factorLow, factorHigh, clamp((back - valueLow) * perWidth, 0.0, 1.0));
}

// A part: optics are products of what is linear on it.
struct PartOptics {
  vec4 base[2];    // luminance, extinction at its ends
  vec4 factor[8];  // of the curves, likewise
  Illumination light[2];
  vec4 corner[4];  // of a transfer function of two dimensions: the patch that the part lies in
  vec2 place[2];   // and where in it
};

vec4 opticsAt(PartOptics part, float share) {
  vec4 optics = mix(part.base[0], part.base[1], share);
  if (kTransferColumns > 0u) {
    const vec2 place = mix(part.place[0], part.place[1], share);
    optics = mix(mix(part.corner[0], part.corner[1], place.x), mix(part.corner[2], part.corner[3], place.x), place.y);
  }
  vec4 factor = vec4(1.0);
  if (kMagnitudePoints > 0u) factor *= mix(part.factor[0], part.factor[1], share);
  if (kBoundaryPoints > 0u) factor *= mix(part.factor[2], part.factor[3], share);
  if (kFieldPoints > 0u) factor *= mix(part.factor[4], part.factor[5], share);
  if (kCosinePoints > 0u) factor *= mix(part.factor[6], part.factor[7], share);
  if (kEmissionPerLength) factor.rgb *= factor.a;
  optics *= factor;
  if (kLitVolume) {
    optics.rgb *= mix(part.light[0].factor, part.light[1].factor, share);
    if (!kEmissionPerLength) optics.rgb += mix(part.light[0].highlight, part.light[1].highlight, share);
  }
  return optics;
}

// Index of the patch along one axis that holds a number, and the axis' values at its ends.
uint axisPatch(uint texel, uint count, float number, out vec2 range) {
  uint patchIndex = 0;
  for (uint i = 1; i + 1u < count; i++) {
    if (texelFetch(appearanceTexels, int(texel + i)).x <= number) patchIndex = i;
  }
  range = vec2(texelFetch(appearanceTexels, int(texel + patchIndex)).x,
               texelFetch(appearanceTexels, int(texel + min(patchIndex + 1u, count - 1u))).x);
  return patchIndex;
}

float nextOnAxis(uint texel, uint count, float front, float back, float share, float nearest) {
  const float perNumber = front == back ? 0.0 : 1.0 / (back - front);
  for (uint i = 0; i < count; i++) {
    const float at = (texelFetch(appearanceTexels, int(texel + i)).x - front) * perNumber;
    if (at > share) nearest = min(nearest, at);
  }
  return nearest;
}

vec2 placeInPatch(vec2 scalars, vec2 gradients, vec2 at) {
  return vec2(clamp((at.x - scalars.x) / max(scalars.y - scalars.x, 1e-30), 0.0, 1.0),
              clamp((at.y - gradients.x) / max(gradients.y - gradients.x, 1e-30), 0.0, 1.0));
}

void findPatch(inout PartOptics part, vec2 front, vec2 back) {
  vec2 scalars;
  vec2 gradients;
  const uint column = axisPatch(kTransferTexel, kTransferColumns, 0.5 * (front.x + back.x), scalars);
  const uint row = axisPatch(kTransferTexel + kTransferColumns, kTransferRows, 0.5 * (front.y + back.y), gradients);
  const uint samples = kTransferTexel + kTransferColumns + kTransferRows;
  for (uint i = 0; i < 4u; i++) {
    const uint x = min(column + (i & 1u), kTransferColumns - 1u);
    const uint y = min(row + (i >> 1), kTransferRows - 1u);
    part.corner[i] = texelFetch(appearanceTexels, int(samples + y * kTransferColumns + x));
  }
  part.place[0] = placeInPatch(scalars, gradients, front);
  part.place[1] = placeInPatch(scalars, gradients, back);
}

// Composites the next part behind light and opacity, as walkRayPart() does, whose state says between which control points the ray is.
// Returns whether it was the segment's last.
bool walkClassifiedPart(inout ClassifiedWalk walk, inout RayParts ray, inout vec3 light, inout float opacity, inout float clearness) {
  const float rise = walk.scalarBack - walk.scalarFront;
  const bool rising = rise >= 0.0;
  const float scalarAhead = rising ? ray.ends.y : ray.ends.x;
  const bool isBeyond = rising ? scalarAhead > walk.scalarBack : scalarAhead <= walk.scalarBack;
  const float shareAhead =
      isBeyond ? 1.0 : clamp(rise == 0.0 ? 0.0 : (scalarAhead - walk.scalarFront) / rise, walk.share, 1.0);

  const vec4 front = walk.front.numbers;
  const vec4 back = walk.back.numbers;
  float end = shareAhead;
  if (kMagnitudePoints > 0u) end = nextPoint(0u, kMagnitudePoints, front.x, back.x, walk.share, end);
  if (kBoundaryPoints > 0u) end = nextPoint(kBoundaryCurve, kBoundaryPoints, front.y, back.y, walk.share, end);
  if (kFieldPoints > 0u) end = nextPoint(kFieldCurve, kFieldPoints, front.z, back.z, walk.share, end);
  if (kCosinePoints > 0u) end = nextPoint(kCosineCurve, kCosinePoints, front.w, back.w, walk.share, end);
  if (kTransferColumns > 0u) {
    end = nextOnAxis(kTransferTexel, kTransferColumns, walk.scalarFront, walk.scalarBack, walk.share, end);
    end = nextOnAxis(kTransferTexel + kTransferColumns, kTransferRows, front.x, back.x, walk.share, end);
  }

  PartOptics part;
  const float scalar0 = walk.scalarFront + walk.share * rise;
  const float scalar1 = walk.scalarFront + end * rise;
  const vec4 number0 = mix(front, back, walk.share);
  const vec4 number1 = mix(front, back, end);
  if (kVertexColors) {
    part.base[0] = mix(walk.front.color, walk.back.color, walk.share);
    part.base[1] = mix(walk.front.color, walk.back.color, end);
  } else if (kTransferColumns > 0u) {
    findPatch(part, vec2(scalar0, number0.x), vec2(scalar1, number1.x));
  } else {
    const vec4 low = texelFetch(transferPoints, ray.interval);
    const vec4 high = texelFetch(transferPoints, ray.interval + 1);
    const float width = ray.ends.y - ray.ends.x;
    const float perWidth = width > 0.0 ? 1.0 / width : 0.0;
    part.base[0] = mix(low, high, clamp((scalar0 - ray.ends.x) * perWidth, 0.0, 1.0));
    part.base[1] = mix(low, high, clamp((scalar1 - ray.ends.x) * perWidth, 0.0, 1.0));
  }
  if (kMagnitudePoints > 0u) curveFactors(0u, kMagnitudePoints, number0.x, number1.x, part.factor[0], part.factor[1]);
  if (kBoundaryPoints > 0u)
    curveFactors(kBoundaryCurve, kBoundaryPoints, number0.y, number1.y, part.factor[2], part.factor[3]);
  if (kFieldPoints > 0u) curveFactors(kFieldCurve, kFieldPoints, number0.z, number1.z, part.factor[4], part.factor[5]);
  if (kCosinePoints > 0u)
    curveFactors(kCosineCurve, kCosinePoints, number0.w, number1.w, part.factor[6], part.factor[7]);
  if (kLitVolume) {
    part.light[0] = Illumination(mix(walk.front.light.factor, walk.back.light.factor, walk.share),
                                 mix(walk.front.light.highlight, walk.back.light.highlight, walk.share));
    part.light[1] = Illumination(mix(walk.front.light.factor, walk.back.light.factor, end),
                                 mix(walk.front.light.highlight, walk.back.light.highlight, end));
  }

  // As long as it may be: nearly linear, and thin enough for the polynomials of addPart().
  const vec4 optics0 = opticsAt(part, 0.0);
  const vec4 middle = opticsAt(part, 0.5);
  const vec4 optics1 = opticsAt(part, 1.0);
  const float whole = (end - walk.share) * walk.thickness;
  const vec4 bend = abs(middle - 0.5 * (optics0 + optics1));
  const float depth = max(max(optics0.w, optics1.w), middle.w) * whole;
  const float bendLight = max(max(bend.r, bend.g), bend.b) * (kEmissionPerLength ? whole : min(depth, 1.0));
  const float bent = max(bend.w * whole, bendLight);
  float keep = 1.0;
  if (bent > kLargestBend) keep = sqrt(kLargestBend / bent);
  if (depth > kLargestPartDepth) keep = min(keep, kLargestPartDepth / depth);
  keep = clamp(keep, kLeastShare, 1.0);
  const bool isCut = keep < 1.0;
  const vec4 kept = opticsAt(part, keep);
  const vec4 mean = (2.0 / 3.0) * (opticsAt(part, 0.5 * keep) - 0.5 * (optics0 + kept));
  const vec4 from = max(optics0 + mean, vec4(0.0));
  const vec4 to = max(kept + mean, vec4(0.0));
  addPart(from.w, to.w, from.rgb, to.rgb - from.rgb, keep * whole, light, opacity, clearness);

  const bool isAtPoint = !isCut && !isBeyond && end == shareAhead;
  walk.share = isCut ? walk.share + keep * (end - walk.share) : end;
  ray.scalar = isAtPoint ? scalarAhead : walk.scalarFront + walk.share * rise;
  ray.surface = isAtPoint ? (rising ? ray.ends.w : ray.ends.z) : -1.0;
  ray.rising = rising;
  if (isAtPoint) ray.interval = rising ? ray.interval + 1 : ray.interval - 1;
  ray.ends = texelFetch(transferPointScalars, ray.interval);
  return !isCut && isBeyond && end >= 1.0;
}
