#include <utility>
#include <vector>

#include "mesh/hard_meshes.h"

namespace tetralux {

// Stick k is stick 0 turned by k / 3 about the z axis, rounded. Seen along z, the sticks lie on the sides of a triangle
// and reach beyond its corners. Each begins near (z = -1), with a horizontal edge, and ends far, with one that leans.
TetMesh cyclicTriple(const FieldFunction& field) {
  TetMesh mesh;
  std::vector<glm::dvec3> points{{-32, -18, -16}, {-32, -6, -16}, {32, -17, 11},  {32, -7, 21},
                                 {32, -19, -16},  {21, -25, -16}, {-1, 36, 11},   {-10, 31, 21},
                                 {0, 37, -16},    {11, 31, -16},  {-31, -19, 11}, {-22, -24, 21}};
  for (glm::dvec3& p : points) p /= 16.0;
  mesh.points = std::move(points);
  mesh.cells = {{0, 2, 1, 3}, {4, 6, 5, 7}, {8, 10, 9, 11}};
  addPreferredField(mesh, "scalar", field);
  return mesh;
}

// Triangle A0 A1 A2 at z = 0 and triangle B0 B1 B2 at z = 1, each a third of a turn apart, B turned on against A by
// about 32 degrees. The prism's sides have the inner diagonals A_i B_i+1; the octahedron's edges A_i+1 B_i lie
// outside. Around the axis, once per i:
//   outer (A_i, A_i+1, B_i, B_i+1) - lower (C, A_i, A_i+1, B_i+1) - upper (C, A_i+1, B_i+1, B_i+2) - next outer
// Outer and lower share a face that leans inwards with z, so outer, which is outside, is above. Upper and the next
// outer share one that leans outwards, so outer is below. Lower and upper share one through the centre and A_i+1
// B_i+1, which leans in the sense of the turn, so the later one is below. All the way round it goes down, that is,
// towards smaller z; the cells are numbered the other way round, so that each lies in front of the next seen along +z.
TetMesh cyclicOctahedron(const FieldFunction& field) {
  TetMesh mesh;
  std::vector<glm::dvec3> points{{64, 0, 0},   {-32, 55, 0},  {-32, -55, 0},  // A
                                 {54, 34, 64}, {-56, 30, 64}, {2, -64, 64},   // B
                                 {0, 0, 32}};                                 // C
  for (glm::dvec3& p : points) p /= 64.0;
  mesh.points = std::move(points);
  constexpr std::uint32_t kCenter = 6;
  const auto a = [](std::uint32_t i) { return i % 3; };
  const auto b = [](std::uint32_t i) { return 3 + i % 3; };
  for (const std::uint32_t i : {2u, 1u, 0u}) {
    mesh.cells.push_back({kCenter, a(i + 1), b(i + 2), b(i + 1)});  // upper
    mesh.cells.push_back({kCenter, a(i), a(i + 1), b(i + 1)});      // lower
    mesh.cells.push_back({a(i), a(i + 1), b(i + 1), b(i)});         // outer
  }
  mesh.cells.push_back({kCenter, a(0), a(2), a(1)});
  mesh.cells.push_back({kCenter, b(0), b(1), b(2)});
  addPreferredField(mesh, "scalar", field);
  return mesh;
}

}  // namespace tetralux
