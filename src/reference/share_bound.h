// What a sample says about the whole.
#pragma once

#include <cstdint>

namespace tetralux::reference {

// Upper end of the one-sided confidence interval of a share, of which a random sample of `count` holds `found` (Clopper
// and Pearson 1934): the largest share at which so few or fewer would be found with a probability of at least
// 1 - confidence. Found by bisection, to 1e-12. Holds for stratified samples as well: with one draw per stratum so few
// are no likelier than with as many draws from the whole (Hoeffding 1956, theorem 4).
//   found        0 to count
//   count        >= 1
//   confidence   between 0 and 1
double upperShareBound(std::uint64_t found, std::uint64_t count, double confidence);

}  // namespace tetralux::reference
