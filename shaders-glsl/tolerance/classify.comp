// Counts the cells of a mesh by the cheapest integration that is good enough for them, whatever the view.
//
// On a segment in one piece of the transfer function, the colour of the mean errs, relative to the segment's opacity, by at most
//
//     |dL| |w - 1/2|,   delta/6 - m/12 <= w - 1/2 <= delta/6,   delta = (a - b)/(a + b),   m = (a + b)/2
//
// (a, b: optical depths by the extinctions at its back and front; w the mean depth of the segment's light as a share of it). A ray may
// go through a cell either way, segments are no longer than its longest edge, and their scalars lie between its vertices': |delta| and
// dL are largest from end to end of that range, and m is at most the largest extinction times the longest edge.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "shared/cell_classes.h"
#include "shared/integration.h"
#include "shared/limits.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#define MESH_CELLS 0
#define MESH_VERTICES 1
#define MESH_CELL_SCALARS 2
#define TRANSFER_PIECES 3
#define TRANSFER_PIECE_BINS 4
#include "include/dispatch.glsl"
#include "include/integration/transfer_pieces.glsl"
#include "include/mesh_access.glsl"

layout(binding = 5, scalar) buffer Counts { CellClassCounts counts; };

layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  uint cellCount;
  float limit;  // of the mean colour's error, relative to the opacity
};

const uint kEmpty = 0u;
const uint kAverage = 1u;
const uint kLinear = 2u;
const uint kPieces = 3u;

float longestEdge(Cell cell) {
  float squares = 0.0;
  for (int i = 0; i < 4; i++) {
    for (int j = i + 1; j < 4; j++) {
      const vec3 edge = cell.position[j] - cell.position[i];
      squares = max(squares, dot(edge, edge));
    }
  }
  return sqrt(squares);
}

float largest(vec3 v) { return max(max(v.x, v.y), v.z); }

void main() {
  const uint cellIndex = linearIndex();
  uint found = 0xffffffffu;
  float mean = 0.0;
  float change = 0.0;
  if (cellIndex < cellCount) {
    const Cell cell = loadCell(mesh, cellIndex);
    const float low = min(min(cell.scalar.x, cell.scalar.y), min(cell.scalar.z, cell.scalar.w));
    const float high = max(max(cell.scalar.x, cell.scalar.y), max(cell.scalar.z, cell.scalar.w));
    const int first = pieceOf(low);
    int last = pieceOf(high);
    // A cell that only touches a control point from below is in one piece.
    if (last > first && texelFetch(transferPieces, 3 * last).x >= high) last--;
    const Optics atLow = opticsInPiece(first, low);
    const Optics atHigh = opticsInPiece(last, high);
    if (first == last) {
      const float sum = atLow.extinction + atHigh.extinction;
      change = largest(abs(atHigh.luminance - atLow.luminance));
      if (sum == 0.0) {
        found = kEmpty;
        change = 0.0;
      } else {
        const float delta = abs(atHigh.extinction - atLow.extinction) / sum;
        const float depth = max(atLow.extinction, atHigh.extinction) * longestEdge(cell);
        mean = change * min(0.5, delta * (1.0 / 6.0) + depth * (1.0 / 12.0));
        found = mean <= limit ? kAverage : kLinear;
      }
    } else {
      found = kPieces;
      for (int piece = first; piece <= last; piece++) {
        const vec4 range = texelFetch(transferPieces, 3 * piece);
        const float width = min(range.y, high) - max(range.x, low);
        change = max(change, largest(abs(texelFetch(transferPieces, 3 * piece + 2).xyz)) * width);
      }
    }
  }
  const uint empty = subgroupAdd(found == kEmpty ? 1u : 0u);
  const uint average = subgroupAdd(found == kAverage ? 1u : 0u);
  const uint linear = subgroupAdd(found == kLinear ? 1u : 0u);
  const uint pieces = subgroupAdd(found == kPieces ? 1u : 0u);
  const float worstMean = subgroupMax(mean);
  const float worstChange = subgroupMax(change);
  if (subgroupElect()) {
    if (empty > 0u) atomicAdd(counts.empty, empty);
    if (average > 0u) atomicAdd(counts.average, average);
    if (linear > 0u) atomicAdd(counts.linear, linear);
    if (pieces > 0u) atomicAdd(counts.pieces, pieces);
    // Not negative, so their bits are in their order.
    atomicMax(counts.worstMean, floatBitsToUint(worstMean));
    atomicMax(counts.worstChange, floatBitsToUint(worstChange));
  }
}
