#include "exact_sign.h"

#include <array>
#include <cmath>
#include <vector>

namespace tetralux::test {
namespace {

// A sum of doubles that do not overlap, smallest first (Shewchuk 1997, GROW-EXPANSION): its sign is that of its last
// part that is not zero.
class ExactSum {
 public:
  void add(double x) {
    for (double& part : parts_) {
      const double sum = x + part;
      const double ofPart = sum - x;
      part = (x - (sum - ofPart)) + (part - ofPart);
      x = sum;
    }
    parts_.push_back(x);
  }

  void addProduct(double x, double y, double z) {
    const double xy = x * y;
    for (const double factor : {std::fma(x, y, -xy), xy}) {
      const double product = factor * z;
      add(std::fma(factor, z, -product));
      add(product);
    }
  }

  ExactDeterminant result() const {
    ExactDeterminant determinant;
    for (const double part : parts_) {
      if (part != 0.0) determinant.sign = part > 0.0 ? 1 : -1;
      determinant.value += part;
    }
    return determinant;
  }

 private:
  std::vector<double> parts_;
};

}  // namespace

// The differences are multiplied out, because they round: the 4 x 4 determinant of the points and a column of ones has
// one product of three coordinates for every way of giving x, y and z to three different points.
ExactDeterminant exactOrientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const std::array<glm::dvec3, 4> p{a, b, c, d};
  ExactSum sum;
  for (size_t x = 0; x < 4; x++) {
    for (size_t y = 0; y < 4; y++) {
      for (size_t z = 0; z < 4; z++) {
        if (x == y || y == z || x == z) continue;
        const std::array<size_t, 4> order{6 - x - y - z, x, y, z};
        double sign = 1.0;
        for (size_t i = 0; i < 4; i++) {
          for (size_t j = i + 1; j < 4; j++) sign = order[i] < order[j] ? sign : -sign;
        }
        sum.addProduct(sign * p[x].x, p[y].y, p[z].z);
      }
    }
  }
  return sum.result();
}

}  // namespace tetralux::test
