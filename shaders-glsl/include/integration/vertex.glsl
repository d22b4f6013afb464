// Projected tetrahedra as Shirley and Tuchman (1990) had them: the fan's vertices have a colour, the mean of that at the
// segment's two ends, and an opacity of the mean extinction; both are interpolated over the triangle, each by itself. The
// vertex shader calls this; a cell that is clipped, which has no fan, is treated so at every pixel.
//
// Returns the colour, not multiplied by the opacity, and the opacity. With emission per length, which is there without
// opacity, too, the light itself takes the place of the colour.
vec4 classifyVertex(float front, float back, float thickness) {
  const Optics f = classify(front);
  const Optics b = classify(back);
  const vec3 luminance = 0.5 * f.luminance + 0.5 * b.luminance;
  const float depth = 0.5 * (f.extinction + b.extinction) * thickness;
  if (kEmissionPerLength) return vec4(luminance * (thickness * meanTransmittance(depth)), oneMinusExp(depth));
  return vec4(luminance, oneMinusExp(depth));
}

// Light and opacity from that.
vec4 vertexLight(vec4 classified) {
  return kEmissionPerLength ? classified : vec4(classified.rgb * classified.a, classified.a);
}
