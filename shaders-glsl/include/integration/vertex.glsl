// Projected tetrahedra as Shirley and Tuchman (1990) had them: the fan's vertices have a colour, the mean of that at the
// segment's two ends, and an opacity of the mean extinction; both are interpolated over the triangle, each by itself. The
// vertex shader calls this; a cell that is clipped, which has no fan, is treated so at every pixel.
//
// Returns the colour, not multiplied by the opacity, and the opacity.
vec4 classifyVertex(float front, float back, float thickness) {
  const Optics f = classify(front);
  const Optics b = classify(back);
  return vec4(0.5 * f.luminance + 0.5 * b.luminance, oneMinusExp(0.5 * (f.extinction + b.extinction) * thickness));
}
