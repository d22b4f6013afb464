#include "render/integration/moment_pairs.h"

#include <glm/vec3.hpp>

#include "base/check.h"
#include "shared/limits.h"

namespace tetralux::render {
namespace {

struct Moments {
  double t = 0.0;
  glm::dvec3 k{0.0};
  glm::dvec3 q{0.0};
};

// One piece from end to end; the formulas are those of include/integration/moments.glsl.
Moments wholePiece(const glm::dvec4& range, const glm::dvec3& low, const glm::dvec3& slope) {
  const double h = range.y - range.x;
  const double t0 = range.z;
  const double dt = range.w * h;
  const double t1 = t0 + dt;
  const glm::dvec3 change = slope * h;
  const glm::dvec3 high = low + change;
  Moments m;
  m.t = 0.5 * h * (t0 + t1);
  m.k = h * ((t0 * low + t1 * high) / 3.0 + (t0 * high + t1 * low) / 6.0);
  m.q = 0.5 * m.t * m.t * high - change * (h * h * (t0 * t0 / 6.0 + t0 * dt / 8.0 + dt * dt / 40.0));
  return m;
}

Moments joined(const Moments& low, const Moments& high) {
  return {low.t + high.t, low.k + high.k, low.q + high.q + low.t * high.k};
}

}  // namespace

std::vector<glm::vec4> makeMomentPairs(const std::vector<glm::vec4>& pieces) {
  const size_t n = pieces.size() / shared::TRANSFER_PIECE_TEXELS;
  CHECK_LE(n, kMostMomentPieces);
  std::vector<Moments> whole(n);
  for (size_t i = 1; i + 1 < n; i++) {
    const glm::vec4* texels = pieces.data() + i * shared::TRANSFER_PIECE_TEXELS;
    whole[i] = wholePiece(glm::dvec4(texels[0]), glm::dvec3(texels[1]), glm::dvec3(texels[2]));
  }
  std::vector<glm::vec4> pairs(2 * n * n, glm::vec4(0.0f));
  for (size_t i = 0; i < n; i++) {
    Moments between;
    for (size_t j = i + 2; j < n; j++) {
      between = joined(between, whole[j - 1]);
      pairs[2 * (i * n + j)] = glm::vec4(glm::dvec4(between.t, between.k));
      pairs[2 * (i * n + j) + 1] = glm::vec4(glm::dvec4(between.q, 0.0));
    }
  }
  return pairs;
}

}  // namespace tetralux::render
