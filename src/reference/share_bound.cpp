#include "reference/share_bound.h"

#include <cmath>

#include "base/check.h"

namespace tetralux::reference {
namespace {

// P(X <= found) for X binomial: a sum of terms from the largest index down, each from the one before.
double atMost(std::uint64_t found, std::uint64_t count, double share) {
  const auto n = static_cast<double>(count);
  auto k = static_cast<double>(found);
  const double last = std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) + k * std::log(share) +
                      (n - k) * std::log1p(-share);
  double term = 1.0;  // in units of the last one, which is the largest where the sum is small
  double sum = 1.0;
  for (; k > 0.0 && term > 1e-18 * sum; k -= 1.0) {
    term *= k / (n - k + 1.0) * (1.0 - share) / share;
    sum += term;
  }
  return std::exp(last + std::log(sum));
}

}  // namespace

double upperShareBound(std::uint64_t found, std::uint64_t count, double confidence) {
  CHECK_LE(found, count);
  CHECK_LE(1u, count);
  CHECK(confidence > 0.0 && confidence < 1.0);
  if (found == count) return 1.0;
  // Above the share found the sum's terms fall from its last one on, so the walk down is short.
  double low = static_cast<double>(found) / static_cast<double>(count);
  double high = 1.0;
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    (atMost(found, count, middle) > 1.0 - confidence ? low : high) = middle;
  }
  return high;
}

}  // namespace tetralux::reference
