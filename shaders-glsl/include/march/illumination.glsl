// Lighting after Phong (1975), two-sided: volume/lighting.h has the formula.
//
// Before including: appearance_texels.glsl.

struct Illumination {
  vec3 factor;     // of a colour
  vec3 highlight;  // added to it
};

// Of unit length and turned to the eye; the direction to the eye for a vector of zero.
vec3 facingNormal(vec3 vector, vec3 toEye) {
  // In units of its largest component, whose square is neither zero nor infinite.
  const vec3 size = abs(vector);
  const float largest = max(max(size.x, size.y), size.z);
  const vec3 normal = largest > 0.0 ? normalize(vector / largest) : toEye;
  return dot(normal, toEye) < 0.0 ? -normal : normal;
}

void addLight(vec4 material, vec3 normal, vec3 toEye, vec3 towards, vec3 rgb, inout Illumination sum) {
  const float cosine = dot(normal, towards);
  if (cosine <= 0.0) return;
  const float mirrored = dot(2.0 * cosine * normal - towards, toEye);
  sum.factor += material.y * cosine * rgb;
  if (mirrored > 0.0) sum.highlight += material.z * pow(mirrored, material.w) * rgb;
}

//   vector   the normal, any length and side
//   toEye    unit length
Illumination illuminate(vec3 vector, vec3 toEye) {
  const vec4 material = texelFetch(appearanceTexels, int(kMaterialTexel));
  const vec3 normal = facingNormal(vector, toEye);
  Illumination sum = Illumination(vec3(material.x), vec3(0.0));
  if (kHeadLight) addLight(material, normal, toEye, toEye, vec3(1.0), sum);
  for (uint i = 0; i < kLights; i++) {
    const int light = int(kLightTexel + i * APPEARANCE_LIGHT_TEXELS);
    addLight(material, normal, toEye, texelFetch(appearanceTexels, light).xyz, texelFetch(appearanceTexels, light + 1).rgb, sum);
  }
  return sum;
}
