// How far from a boundary between two materials a place is, by the field alone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fields/gradients.h"

namespace tetralux {

struct BoundaryDistances {
  double sigma = 0.0;             // width of boundaries that was used, world units
  std::vector<double> distances;  // per vertex, world units, > 0 where the field is larger than at the boundary
};

// A boundary is taken for a step of the field, blurred by a Gaussian of standard deviation sigma: f is an error
// function of the distance x along the gradient, so f''/f' = -x / sigma^2, with f' = |gradient| and f'' the second
// derivative along the gradient, measured as (grad f') . gradient / f' (Kindlmann and Durkin 1998). No distance is
// larger than 6 sigma, where an error function has 1.5e-8 of its largest slope; that is also what places without any
// slope get.
//   gradients   of the field, as fit.gradients() gives them
//   sigma       > 0, world units; none: largest f' / (sqrt(e) largest |f''|), an error function's, but at most
//   `diagonal` diagonal    of the mesh's box, world units
BoundaryDistances boundaryDistances(const GradientFit& fit, std::span<const glm::dvec3> gradients,
                                    std::optional<double> sigma, double diagonal);

// Lengths of gradients, finite.
std::vector<double> gradientMagnitudes(std::span<const glm::dvec3> gradients);

}  // namespace tetralux
