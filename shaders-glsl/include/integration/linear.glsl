// Luminance and extinction linear between the segment's two ends (Williams and Max 1992; Williams, Max and Stein 1998): exact
// for that, without a table. Control points between the ends are not seen.
vec4 integrateLinear(float front, float back, float thickness) {
  const Optics f = classify(front);
  const Optics b = classify(back);
  const float depthFront = min(f.extinction * thickness, 1e8);
  const float depthBack = min(b.extinction * thickness, 1e8);
  const float opacity = oneMinusExp(0.5 * depthFront + 0.5 * depthBack);
  return vec4(f.luminance * opacity + (b.luminance - f.luminance) * linearMoment(depthBack, depthFront), opacity);
}
