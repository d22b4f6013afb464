// The mesh on the device. Texel buffers where they reach (software devices read them about ten times faster than
// storage buffers), addresses where a mesh is longer than a texel buffer may be.
//
// Before including: MESH_CELLS, MESH_VERTICES, MESH_CELL_SCALARS are the binding numbers.
#include "include/pieces.glsl"

layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;
layout(constant_id = SPEC_CELL_FIELD) const bool kCellField = false;

layout(binding = MESH_CELLS) uniform usamplerBuffer meshCells;        // 4 vertex indices
layout(binding = MESH_VERTICES) uniform samplerBuffer meshVertices;   // position in mesh space, scalar
layout(binding = MESH_CELL_SCALARS) uniform samplerBuffer meshCellScalars;  // used when kCellField

layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer MeshCellsAt { uvec4 data[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer MeshCellPiecesAt {  // gpu/pieced_buffer.h
  uint bits;
  uint unused;
  MeshCellsAt pieces[kMostPieces];
};
layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer MeshVerticesAt { vec4 data[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer MeshCellScalarsAt { float data[]; };

// The same as addresses; part of the push constants of every pass that reads the mesh.
struct MeshAddresses {
  MeshCellPiecesAt cells;
  MeshVerticesAt vertices;
  MeshCellScalarsAt cellScalars;
};

struct Cell {
  vec3 position[4];  // mesh space
  vec4 scalar;       // at the four vertices, normalised to the field's range: -0.5 to 0.5
};

uvec4 loadCellVertices(MeshAddresses mesh, uint cell) {
  if (!kWideAddressing) return texelFetch(meshCells, int(cell));
  const uint bits = mesh.cells.bits;
  return mesh.cells.pieces[cell >> bits].data[cell & ((1u << bits) - 1u)];
}

vec4 loadVertex(MeshAddresses mesh, uint vertex) {
  return kWideAddressing ? mesh.vertices.data[vertex] : texelFetch(meshVertices, int(vertex));
}

float loadCellScalar(MeshAddresses mesh, uint cell) {
  return kWideAddressing ? mesh.cellScalars.data[cell] : texelFetch(meshCellScalars, int(cell)).x;
}

Cell loadCell(MeshAddresses mesh, uint cell) {
  Cell result;
  const uvec4 index = loadCellVertices(mesh, cell);
  for (int i = 0; i < 4; i++) {
    const vec4 vertex = loadVertex(mesh, index[i]);
    result.position[i] = vertex.xyz;
    result.scalar[i] = vertex.w;
  }
  if (kCellField) result.scalar = vec4(loadCellScalar(mesh, cell));
  return result;
}
