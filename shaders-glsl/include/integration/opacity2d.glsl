// Stein, Becker and Max (1994): opacity 1 - exp(-tau l) from a table over the mean of the end points' extinctions, in parts of
// the largest, and the thickness, in parts of the longest edge; colour is the mean of the end points'.
vec4 integrateOpacityTable(float front, float back, float thickness) {
  const Optics f = classify(front);
  const Optics b = classify(back);
  const float extinction = 0.5 * f.extinction + 0.5 * b.extinction;
  const TableScale scale = tableScale();
  const float opacity =
      sampleTable2d(vec2(extinction / max(scale.largestExtinction, 1e-37), thickness / scale.thickness)).x;
  return vec4((0.5 * f.luminance + 0.5 * b.luminance) * opacity, opacity);
}
