// The basic variant of Marroquim et al. (2008): the segment's mean scalar is classified, and the whole segment is given its
// colour and extinction. Exact where the transfer function is constant; opacity also where extinction is linear in s.
vec4 integrateAverage(float front, float back, float thickness) {
  const Optics optics = classify(0.5 * front + 0.5 * back);
  const float depth = optics.extinction * thickness;
  const float opacity = oneMinusExp(depth);
  if (kEmissionPerLength) return vec4(optics.luminance * (thickness * meanTransmittance(depth)), opacity);
  return vec4(optics.luminance * opacity, opacity);
}
