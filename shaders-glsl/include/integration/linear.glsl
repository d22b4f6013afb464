// Luminance and extinction linear between the segment's two ends (Williams and Max 1992; Williams, Max and Stein 1998): exact
// for that, without a table. Control points between the ends are not seen.
//
// With emission per length, I = D (E_f Psi + (E_b - E_f) X). Psi and X are tiny where D is large, so what counts is their relative
// error, which closed forms in the depths at the ends lose to cancellation. The segment is cut into parts of an optical depth of at
// most 1 instead, as in exact.glsl; a thin one, which most are, is one part.

vec4 integrateLinearGlow(Optics front, Optics back, float thickness) {
  vec3 light = vec3(0.0);
  float opacity = 0.0;
  float clearness = 1.0;
  float share = 0.0;
  for (int round = 0; round < kMostParts; round++) {
    const float extinction0 = mix(front.extinction, back.extinction, share);
    const float part = (1.0 - share) * thickness;
    const float keep = keptShare(extinction0, back.extinction, part);
    addPart(extinction0, mix(extinction0, back.extinction, keep), mix(front.luminance, back.luminance, share),
            (back.luminance - front.luminance) * ((1.0 - share) * keep), part * keep, light, opacity, clearness);
    share = mix(share, 1.0, keep);
    if (keep >= 1.0 || isWalkOpaque(opacity, clearness)) break;
  }
  return vec4(light, opacity);
}

vec4 integrateLinear(float front, float back, float thickness) {
  const Optics f = classify(front);
  const Optics b = classify(back);
  if (kEmissionPerLength) return integrateLinearGlow(f, b, thickness);
  const float depthFront = min(f.extinction * thickness, 1e8);
  const float depthBack = min(b.extinction * thickness, 1e8);
  const float opacity = oneMinusExp(0.5 * depthFront + 0.5 * depthBack);
  return vec4(f.luminance * opacity + (b.luminance - f.luminance) * linearMoment(depthBack, depthFront), opacity);
}
