// Ids of the specialisation constants. One id means the same in every shader that has it.
#ifndef TETRALUX_SHARED_SPEC_IDS_H
#define TETRALUX_SHARED_SPEC_IDS_H

#define SPEC_WIDE_ADDRESSING 0  // bool: buffers beyond a descriptor's range are reached by their address
#define SPEC_PERSPECTIVE 1      // bool: perspective, else orthographic
#define SPEC_CELL_FIELD 2       // bool: one scalar per cell, else one per vertex
#define SPEC_NEAR_CELLS 3       // bool: cells may reach the eye's plane (shared/clipped_cells.h)
#define SPEC_FIRST_DIGIT 4      // bool: first pass of the sort, which drops culled cells and numbers the rest
#define SPEC_RELATIONS 5        // bool: cells are also related across gaps (order/relate.comp)
#define SPEC_RELATE_CHECK 6     // bool: relations are counted, not added
#define SPEC_KBUFFER 7          // uint: size of the k-buffer; 0: fragments are sorted
#define SPEC_SILHOUETTE 8       // bool: cells are drawn as outlines, rays are clipped per fragment; else as fans
#define SPEC_SUBPIXELS 9        // uint: steps per pixel to which vertices of fans are snapped; 0: they are not
#define SPEC_INTEGRATION 10     // uint: how light is integrated through a segment (shared/integration.h)
#define SPEC_INTERPOLATION 11   // uint: what is interpolated over a fan's triangles (shared/integration.h)
#define SPEC_TABLE_FETCH 12     // bool: tables are interpolated by the shader, not by the sampler
#define SPEC_TABLE_FORMAT 13    // uint: how the entries of a table are stored (shared/integration.h)
#define SPEC_PART_ACCURACY 14        // uint: which polynomials the exact method integrates its parts by (shared/integration.h)
#define SPEC_LEAST_TRANSMITTANCE 15  // float: what lies behind it is left out
#define SPEC_EMISSION_PER_LENGTH 20  // bool: light per unit of length, else per unit of extinction
#define SPEC_OUTPUT 21               // uint: what is handed to the blending (shared/target_output.h)
#define SPEC_CLIP_PLANES 22          // uint: their number
#define SPEC_LIGHTS 23               // uint: directional lights
#define SPEC_HEAD_LIGHT 24           // bool: a light at the eye
#define SPEC_ISOSURFACES 25          // bool: there are some
#define SPEC_VOLUME 26               // bool: what lies between isosurfaces shows
#define SPEC_RAY_ENDS 27             // bool: opaque surfaces end rays
#define SPEC_ISOSURFACE_COUNT 28     // uint
#define SPEC_CLASSIFIED 29           // bool: extinction and luminance depend on more than the scalar
#define SPEC_LIT_VOLUME 30           // bool: luminance is lit by the gradient
#define SPEC_VERTEX_COLORS 31        // bool: luminance and extinction come from vertices
#define SPEC_CURVE_MAGNITUDE 32      // uint: points of the factor that depends on the gradient's length; 0: none
#define SPEC_CURVE_BOUNDARY 33       // uint: ... on the distance from a boundary
#define SPEC_CURVE_FIELD 34          // uint: ... on a second field
#define SPEC_CURVE_COSINE 35         // uint: ... on the angle between gradient and ray
#define SPEC_TRANSFER_COLUMNS 36     // uint: scalars of a transfer function of two dimensions; 0: none
#define SPEC_TRANSFER_ROWS 37        // uint: its gradients
#define SPEC_CHOOSE_TRIANGLE 38      // bool: second run of surface/meet.comp
#define SPEC_COUNT_WORK 39           // bool: rays that walk count their steps (MarchCounts)
#define SPEC_DISPATCH_THREADS 40     // uint: threads that share out workgroups in equal runs; 1: whoever is free takes the next
#define SPEC_LIST_FACES 41           // bool: second run of skip/enclose.comp
#define SPEC_TURN_ROUNDS 42          // uint: rounds that a ray out of the mesh waits for others of its subgroup at most
#define SPEC_JOB_LANES 43            // uint: invocations that share a job of march/enter.comp, a power of two up to MARCH_WORKGROUP

#endif
