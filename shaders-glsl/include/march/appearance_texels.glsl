// The list of what is shown beside the volume, and where in it each part begins (shared/appearance.h).
//
// Before including: APPEARANCE_TEXELS is a binding number.
#include "shared/appearance.h"
#include "shared/spec_ids.h"

layout(constant_id = SPEC_CLIP_PLANES) const uint kClipPlanes = 0;
layout(constant_id = SPEC_LIGHTS) const uint kLights = 0;
layout(constant_id = SPEC_HEAD_LIGHT) const bool kHeadLight = true;
layout(constant_id = SPEC_ISOSURFACE_COUNT) const uint kSurfaces = 0;
// Points of the curves of factors, in the order of ModulatedBy; 0: no curve.
layout(constant_id = SPEC_CURVE_MAGNITUDE) const uint kMagnitudePoints = 0;
layout(constant_id = SPEC_CURVE_BOUNDARY) const uint kBoundaryPoints = 0;
layout(constant_id = SPEC_CURVE_FIELD) const uint kFieldPoints = 0;
layout(constant_id = SPEC_CURVE_COSINE) const uint kCosinePoints = 0;

layout(binding = APPEARANCE_TEXELS) uniform samplerBuffer appearanceTexels;  // shared/appearance.h

const uint kMaterialTexel = kClipPlanes * APPEARANCE_CLIP_TEXELS;
const uint kLightTexel = kMaterialTexel + 1u;
const uint kSurfaceTexel = kLightTexel + kLights * APPEARANCE_LIGHT_TEXELS;
const uint kCurveTexel = kSurfaceTexel + kSurfaces * APPEARANCE_SURFACE_TEXELS;
const uint kTransferTexel = kCurveTexel + APPEARANCE_CURVE_TEXELS * (kMagnitudePoints + kBoundaryPoints + kFieldPoints + kCosinePoints);
