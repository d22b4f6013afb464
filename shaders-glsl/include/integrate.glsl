// Light and opacity of one ray segment, by the method that the pipeline is specialised for.
//
// Before including: shared/spec_ids.h, and the binding numbers TRANSFER_PIECES, TRANSFER_PIECE_BINS. With INTEGRATION_NUMBERS,
// INTEGRATION_TABLE_2D and INTEGRATION_TABLE_3D as well, every method can be chosen; without them there is only the exact one.
// All but INTEGRATION_PPI and INTEGRATION_MOMENTS know emission per length.
#include "shared/integration.h"
#include "include/integration/exact.glsl"

#ifdef INTEGRATION_NUMBERS
layout(constant_id = SPEC_INTEGRATION) const uint kIntegration = INTEGRATION_EXACT;
#include "include/integration/tables.glsl"
#include "include/integration/segment_functions.glsl"
#include "include/integration/average.glsl"
#include "include/integration/vertex.glsl"
#include "include/integration/linear.glsl"
#include "include/integration/ppi.glsl"
#include "include/integration/opacity2d.glsl"
#include "include/integration/preintegration.glsl"
#include "include/integration/moments.glsl"
#endif

// Premultiplied light and opacity.
//   front, back   normalised scalars at the segment's ends
//   thickness     length along the ray, mesh units, >= 0
vec4 integrateSegment(float front, float back, float thickness) {
#ifdef INTEGRATION_NUMBERS
  if (kIntegration == INTEGRATION_VERTEX) return vertexLight(classifyVertex(front, back, thickness));
  if (kIntegration == INTEGRATION_AVERAGE) return integrateAverage(front, back, thickness);
  if (kIntegration == INTEGRATION_OPACITY2D) return integrateOpacityTable(front, back, thickness);
  if (kIntegration == INTEGRATION_PREINT2D) return integrateMeanThickness(front, back, thickness);
  if (kIntegration == INTEGRATION_PREINT3D || kIntegration == INTEGRATION_PREINT3D_LOG ||
      kIntegration == INTEGRATION_PREINT3D_OCTAVE)
    return integratePreintegrated(front, back, thickness);
  if (kIntegration == INTEGRATION_PPI) return integratePartial(front, back, thickness);
  if (kIntegration == INTEGRATION_LINEAR) return integrateLinear(front, back, thickness);
  if (kIntegration == INTEGRATION_MOMENTS) return integrateMoments(front, back, thickness);
#endif
  return integrateExact(front, back, thickness);
}
