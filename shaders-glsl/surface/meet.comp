// Where rays meet triangles of opaque surfaces first. One invocation does a job of march/bin.comp, a triangle in a tile.
//
// Run twice: for the depth nearest to the eye at every pixel, then for the first triangle that has it. Which rays meet a triangle is decided by the
// same signs for all triangles at an edge, so a closed surface lets no ray through.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/clipped_cells.h"
#include "shared/frame_view.h"
#include "shared/march.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"
#include "shared/visibility.h"

layout(local_size_x = MARCH_WORKGROUP) in;

#define MARCH_TILES 5
#include "include/dispatch.glsl"
#include "include/march_pixel.glsl"
#define SURFACE_VERTICES 1
#include "include/surface_ray.glsl"

layout(constant_id = SPEC_CHOOSE_TRIANGLE) const bool kChooseTriangle = false;

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
layout(binding = 2) uniform usamplerBuffer triangles;  // three vertices, surface
layout(binding = 3) uniform usamplerBuffer jobs;
layout(binding = 4, scalar) readonly buffer Counts { MarchCounts counts; };
layout(binding = 6, scalar) buffer Nearest { uint nearest[]; };  // per pixel of the band, depthOrder()
layout(binding = 7, scalar) buffer Chosen { uint chosen[]; };    // triangle

layout(push_constant, scalar) uniform Push {
  PixelBand band;
  uint jobCapacity;
};

void main() {
  const uint index = dealtIndex();
  if (index >= min(counts.jobs, jobCapacity)) return;
  const uvec2 job = texelFetch(jobs, int(index)).xy;
  const uvec2 origin = tileOrigin(band, job.y >> MARCH_JOB_PLACE_BITS);
  const uvec2 first = uvec2(job.y & 7u, (job.y >> 3) & 7u);
  const uvec2 last = uvec2((job.y >> 6) & 7u, (job.y >> 9) & 7u);
  const uvec3 corners = texelFetch(triangles, int(job.x)).xyz;

  uvec2 at = first;
  for (uint i = 0; i < MARCH_TILE * MARCH_TILE; i++) {
    const uvec2 place = origin + at;
    const TriangleMeeting met = meetTriangle(view, uvec2(place.x, band.firstRow + place.y), corners);
    if (met.isMet) {
      const uint pixel = place.y * band.width + place.x;
      const uint order = depthOrder(met.depth);
      if (!kChooseTriangle)
        atomicMin(nearest[pixel], order);
      else if (nearest[pixel] == order)
        atomicMin(chosen[pixel], job.x);
    }
    at.x++;
    if (at.x > last.x) at = uvec2(first.x, at.y + 1u);
    if (at.y > last.y) break;
  }
}
