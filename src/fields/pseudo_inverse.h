// Inverse of a small symmetric matrix that may be singular.
#pragma once

#include <glm/mat3x3.hpp>

namespace tetralux {

// The pseudo-inverse (Penrose 1955) of a symmetric matrix without negative eigenvalues: where the matrix maps a space
// of fewer dimensions onto itself, the inverse within that space, and zero across it, so that it gives solutions of
// least norm. Zero for the zero matrix, and for one with an element that is not finite.
//   relativeRank   eigenvalues below this part of the largest count as zero, at least 1e-15
glm::dmat3 pseudoInverse(const glm::dmat3& symmetric, double relativeRank);

}  // namespace tetralux
