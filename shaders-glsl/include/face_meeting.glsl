// Where a ray meets a face. With APPEARANCE defined, rounding cannot take a scalar beyond those of the face's corners.
//
// Before including: ray_signs.glsl, shared/visibility.h.

// A face; the ray sees its corners anticlockwise.
struct Face {
  Corner a, b, c;
};

// A place on the ray.
struct Place {
  real depth;
  float scalar;
};

// Where the ray meets a face: a convex combination of the corners, whatever the rounding.
struct Meeting {
  Place there;
  real area;   // of the projected face, twice
};

Meeting meeting(Face face) {
  const real3 weight =
      max(real3(crossed(face.b, face.c), crossed(face.c, face.a), crossed(face.a, face.b)), real3(0.0));
  const real area = weight.x + weight.y + weight.z;
  const real depth = weight.x * face.a.depth + weight.y * face.b.depth + weight.z * face.c.depth;
  const real scalar = weight.x * face.a.scalar + weight.y * face.b.scalar + weight.z * face.c.scalar;
  const real inverse = 1.0 / max(area, kNoArea);
#ifdef APPEARANCE
  // Rounding must not take a face of one scalar across an isosurface of that value.
  const float low = min(min(face.a.scalar, face.b.scalar), face.c.scalar);
  const float high = max(max(face.a.scalar, face.b.scalar), face.c.scalar);
  return Meeting(Place(area > kNoArea ? depth * inverse : face.a.depth,
                       area > kNoArea ? clamp(float(scalar * inverse), low, high) : face.a.scalar),
                 area);
#else
  return Meeting(Place(area > kNoArea ? depth * inverse : face.a.depth,
                       area > kNoArea ? float(scalar * inverse) : face.a.scalar),
                 area);
#endif
}

// Depths as integers of the same order, without the last bit. They are within 1.8 of the mesh's centre: what is compared is positive.
uint depthRank(real depth) { return floatBitsToUint(float(depth) + 4.0) & ~ENTRY_BIT; }

Place meetFirst(Face face) { return meeting(face).there; }
