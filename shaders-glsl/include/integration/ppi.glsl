// Partial pre-integration (Moreland and Angel 2004, section 4): as linear.glsl, with Psi from a table over
// gamma = tau D/(1 + tau D), which does not depend on the transfer function. Texel (i, j) holds Psi at
// gamma_b = i/(n - 1), gamma_f = j/(n - 1).
vec4 integratePartial(float front, float back, float thickness) {
  const Optics f = classify(front);
  const Optics b = classify(back);
  const float depthFront = min(f.extinction * thickness, 1e8);
  const float depthBack = min(b.extinction * thickness, 1e8);
  const float psi = sampleTable2d(vec2(depthBack / (1.0 + depthBack), depthFront / (1.0 + depthFront))).x;
  const float opacity = oneMinusExp(0.5 * depthFront + 0.5 * depthBack);
  // Psi - zeta from a rounded table may leave its range where the segment is thin; no colour may become negative by that.
  const float moment = clamp(psi - 1.0 + opacity, 0.0, opacity);
  return vec4(f.luminance * opacity + (b.luminance - f.luminance) * moment, opacity);
}
