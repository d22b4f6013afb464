#include "mesh/delaunay_predicates.h"

#include <algorithm>
#include <array>

namespace tetralux {

// On the paraboloid t = x^2 + y^2 + z^2 the test is whether p lies below the hyperplane through a, b, c, d. Raise each
// point's t by an amount of its own, infinitely smaller than those of all lexicographically greater points (Devillers,
// Teillaud 2011, "Perturbations for Delaunay and weighted Delaunay 3D triangulations"). The test is linear in t, so
// its sign is that of the first coefficient other than 0, from the greatest point down. The coefficient of a vertex is
// orient3d with p in its place; p's own is -orient3d(a, b, c, d), never 0, so there always is an answer.
bool breakCosphericalTie(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d,
                         const GridPoint& p) {
  std::array<const GridPoint*, 5> falling{&a, &b, &c, &d, &p};
  std::sort(falling.begin(), falling.end(),
            [](const GridPoint* u, const GridPoint* v) { return lexicographicLess(*v, *u); });
  for (const GridPoint* raised : falling) {
    if (raised == &p) return false;
    const auto replaced = [&](const GridPoint& vertex) -> const GridPoint& { return raised == &vertex ? p : vertex; };
    const std::int64_t coefficient = orient3d(replaced(a), replaced(b), replaced(c), replaced(d));
    if (coefficient != 0) return coefficient > 0;
  }
  return false;
}

}  // namespace tetralux
