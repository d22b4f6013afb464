// Lighting after Phong (1975, "Illumination for computer generated pictures"), two-sided.
//
// With N the unit normal at a point turned to the eye (N.V >= 0), V the unit vector to the eye, against the ray, and
// for every light L_i the unit vector towards it and I_i its rgb:
//
//     lit(c) = c (ambient + diffuse sum_i I_i max(0, N.L_i)) + specular sum_i I_i max(0, R_i.V)^shininess
//     R_i = 2 (N.L_i) N - L_i;   lights with N.L_i <= 0 give nothing
//
// The head light has L = V and I = (1, 1, 1). Where there is no normal (a gradient of zero), N = V.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace tetralux {

enum class Shading {
  None,   // the colour itself
  Flat,   // normals of cells or triangles
  Phong,  // normals of vertices, interpolated
};

// A light that is infinitely far away.
struct DirectionalLight {
  glm::dvec3 direction{0.0, 0.0, 1.0};  // towards the light, world, unit length
  glm::dvec3 rgb{1.0};                  // linear, >= 0
};

struct Lighting {
  double ambient = 0.2;     // >= 0
  double diffuse = 0.8;     // >= 0
  double specular = 0.2;    // >= 0
  double shininess = 30.0;  // >= 1
  bool headLight = true;
  std::vector<DirectionalLight> lights;
};

// The share of a colour that is seen, and what is added to it.
struct Illumination {
  glm::dvec3 factor{1.0};
  glm::dvec3 highlight{0.0};

  glm::dvec3 lit(const glm::dvec3& rgb) const { return rgb * factor + highlight; }
};

// The above.
//   normal   any length; zero: none
//   toEye    V, unit length
Illumination illuminate(const Lighting& lighting, const glm::dvec3& normal, const glm::dvec3& toEye);

}  // namespace tetralux
