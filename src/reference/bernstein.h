// Polynomials on [0, 1] in Bernstein's form (Farouki 2012, "The Bernstein polynomial basis: a centennial
// retrospective"): sum over i of c_i C(n, i) x^i (1 - x)^(n - i).
//
// Factors that are linear and nowhere negative have no negative coefficient, nor have their products and integrals: all
// of them are computed without cancellation.
#pragma once

#include <utility>
#include <vector>

namespace tetralux::reference {

// Value: double, or a vector whose components are polynomials of their own.
template <typename Value>
class Bernstein {
 public:
  //   coefficients   one more than the degree, at least one; the first and the last are the values at 0 and 1
  explicit Bernstein(std::vector<Value> coefficients) : c_(std::move(coefficients)) {}

  const std::vector<Value>& coefficients() const { return c_; }
  size_t degree() const { return c_.size() - 1; }

  //   x   0 to 1
  Value at(double x) const {
    const size_t n = degree();
    if (n == 0) return c_[0];
    // Horner's scheme in x, each term multiplied by 1 - x as often as terms follow it.
    Value sum = c_[0] * (1.0 - x);
    double term = 1.0;  // C(n, i) x^i
    for (size_t i = 1; i < n; i++) {
      term *= x * static_cast<double>(n - i + 1) / static_cast<double>(i);
      sum = (sum + term * c_[i]) * (1.0 - x);
    }
    return sum + term * x / static_cast<double>(n) * c_[n];
  }

  // Farouki 2012, section 4.2, component by component.
  Bernstein operator*(const Bernstein& other) const {
    const size_t n = degree();
    const size_t m = other.degree();
    std::vector<Value> product(n + m + 1, Value(0.0));
    for (size_t i = 0; i <= n; i++) {
      for (size_t j = 0; j <= m; j++)
        product[i + j] += binomial(n, i) * binomial(m, j) / binomial(n + m, i + j) * (c_[i] * other.c_[j]);
    }
    return Bernstein(std::move(product));
  }

  // From 0 to x.
  Bernstein integral() const {
    const double share = 1.0 / static_cast<double>(c_.size());
    std::vector<Value> sums(c_.size() + 1, Value(0.0));
    for (size_t i = 0; i < c_.size(); i++) sums[i + 1] = sums[i] + share * c_[i];
    return Bernstein(std::move(sums));
  }

 private:
  static double binomial(size_t n, size_t k) {
    double product = 1.0;
    for (size_t i = 1; i <= k; i++) product *= static_cast<double>(n - k + i) / static_cast<double>(i);
    return product;
  }

  std::vector<Value> c_;
};

}  // namespace tetralux::reference
