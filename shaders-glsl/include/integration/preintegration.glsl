// Pre-integrated segments: light and opacity from a table over front scalar, back scalar and thickness.

// With emission per length a table holds not the light, which has no bound, but light per length, which is never above the largest
// emission and does not become small for thin segments, so that a fixed-point format keeps its digits at every thickness.
vec4 entryLight(vec4 entry, float thickness) {
  return kEmissionPerLength ? vec4(entry.rgb * thickness, entry.a) : entry;
}

// Roettger, Kraus and Ertl (2000), section 4: integrated for the mean thickness, extrapolated linearly. Where that would
// be more than opaque the segment is opaque.
vec4 integrateMeanThickness(float front, float back, float thickness) {
  const TableScale scale = tableScale();
  const vec4 color = entryLight(sampleTable2d(vec2(front + 0.5, back + 0.5)) * scale.value, scale.thickness);
  return color * min(thickness / scale.thickness, 1.0 / max(color.a, 1e-37));
}

// Where a thickness lies on the table's third axis, 0 to 1.
//   share   of the largest thickness
//   size    texels along the axis, at least 2
float linearAxis(float share) { return min(share, 1.0); }

// Kraus, Qiao and Ebert (2004), equation 1: texel 0 is 0, texel k is 2^(k - 1) times the smallest thickness, which is
// 2^-(size - 2) of the largest.
float logarithmicAxis(float share, float size) {
  const float smallest = share * exp2(size - 2.0);
  return min((max(log2(max(smallest, 1e-37)), 0.0) + min(smallest, 1.0)) / (size - 1.0), 1.0);
}

// The same texels with a coordinate that is linear between each two of them. Opacity nearly grows with the thickness; the
// logarithm's fraction lets thin segments come out up to 6 % too opaque.
float octaveAxis(float share, float size) {
  const float smallest = share * exp2(size - 2.0);
  const float octave = max(floor(log2(max(smallest, 1.0))), 0.0);
  const float above = octave + smallest * exp2(-octave);
  return min((smallest < 1.0 ? smallest : above) / (size - 1.0), 1.0);
}

// Section 3 of Roettger, Kraus and Ertl (2000), the third axis as the method has it.
vec4 integratePreintegrated(float front, float back, float thickness) {
  const TableScale scale = tableScale();
  const float share = thickness / scale.thickness;
  const float size = float(textureSize(integrationTable3d, 0).z);
  float third = linearAxis(share);
  if (kIntegration == INTEGRATION_PREINT3D_LOG) third = logarithmicAxis(share, size);
  if (kIntegration == INTEGRATION_PREINT3D_OCTAVE) third = octaveAxis(share, size);
  return entryLight(sampleTable3d(vec3(front + 0.5, back + 0.5, third)) * scale.value, thickness);
}
