// The numbers of a ray's geometry: single precision, or double where a frame asks for it (render/precision.h).
#ifdef REAL_IS_DOUBLE
#define real double
#define real2 dvec2
#define real3 dvec3
#define real4 dvec4
// The smallest area of a face that is not taken for none.
const real kNoArea = 1e-70lf;
// Where a ray is beside an edge that it meets: far nearer than what rounding leaves of two places.
const real2 kBesideEdge = real2(1e-50lf, 1e-65lf);
// Places are rounded by so much of the mesh's size (with some room).
const real kPlaceRounding = 2e-15lf;
#else
#define real float
#define real2 vec2
#define real3 vec3
#define real4 vec4
const real kNoArea = 1e-37;
const real2 kBesideEdge = real2(1e-20, 1e-27);
const real kPlaceRounding = 1e-6;
#endif
