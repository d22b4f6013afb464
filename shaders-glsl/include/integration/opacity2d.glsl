// Stein, Becker and Max (1994): opacity 1 - exp(-tau l) from a table over the mean of the end points' extinctions, in parts of
// the largest, and the thickness, in parts of the longest edge; colour is the mean of the end points'.
vec4 integrateOpacityTable(float front, float back, float thickness) {
  const Optics f = classify(front);
  const Optics b = classify(back);
  const float extinction = 0.5 * f.extinction + 0.5 * b.extinction;
  const TableScale scale = tableScale();
  const float opacity =
      sampleTable2d(vec2(extinction / max(scale.largestExtinction, 1e-37), thickness / scale.thickness)).x;
  if (kEmissionPerLength) {
    // The mean transmittance is opacity/depth. Of a small opacity the table's format leaves no digits: below 1/16 a series, with an
    // error of depth^3/24 < 1.1e-5.
    const float depth = extinction * thickness;
    const float transmittance = depth < 0.0625 ? 1.0 - depth * (0.5 - depth * (1.0 / 6.0)) : min(opacity / depth, 1.0);
    return vec4((0.5 * f.luminance + 0.5 * b.luminance) * (thickness * transmittance), opacity);
  }
  return vec4((0.5 * f.luminance + 0.5 * b.luminance) * opacity, opacity);
}
