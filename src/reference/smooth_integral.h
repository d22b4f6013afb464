// Light and opacity of a part of a ray along which the optics are polynomials, by quadrature.
#pragma once

#include <array>
#include <cmath>
#include <glm/vec3.hpp>

#include "reference/bernstein.h"
#include "volume/optical_model.h"

namespace tetralux::reference {

// int_0^1 exp(-D(x)) e(x) dx and 1 - exp(-D(1)), with a relative error of about 1e-13 while e is a polynomial of no
// more than about twenty degrees. D is evaluated as the polynomial that it is, so there is no error but the
// quadrature's: of Gauss and Legendre with 16 points (Abramowitz and Stegun 1964, table 25.4), which is exact to degree
// 31, over panels that are halved until none absorbs more than kPanelDepth, so that the term of exp(-D) with D^k is
// below 0.5^k / k!.
class SmoothIntegral {
 public:
  //   depth   D, the optical depth from the front to x; it does not fall
  explicit SmoothIntegral(Bernstein<double> depth) : depth_(std::move(depth)) {}

  //   emission   light emitted per x, of x: glm::dvec3(double)
  template <typename Emission>
  SegmentOptics operator()(const Emission& emission) const {
    const double total = depth_.at(1.0);
    SegmentOptics result;
    result.alpha = -std::expm1(-total);
    addPanel({0.0, 1.0, 0.0, total}, emission, result.light);
    return result;
  }

 private:
  struct Panel {
    double x0, x1;
    double depth0, depth1;
  };

  template <typename Emission>
  void addPanel(const Panel& p, const Emission& emission, glm::dvec3& light) const {
    if (p.depth0 > kOpaqueDepth) return;
    const double middle = 0.5 * (p.x0 + p.x1);
    if (p.depth1 - p.depth0 > kPanelDepth && p.x0 < middle && middle < p.x1) {
      const double depth = depth_.at(middle);
      addPanel({p.x0, middle, p.depth0, depth}, emission, light);
      addPanel({middle, p.x1, depth, p.depth1}, emission, light);
      return;
    }
    const double half = 0.5 * (p.x1 - p.x0);
    const auto at = [&](double x) { return std::exp(-depth_.at(x)) * emission(x); };
    for (const Node& node : kNodes)
      light += half * node.weight * (at(middle - half * node.x) + at(middle + half * node.x));
  }

  static constexpr double kPanelDepth = 0.5;

  // exp(-45) is 3e-20: nothing behind it shows in double precision.
  static constexpr double kOpaqueDepth = 45.0;

  struct Node {
    double x, weight;
  };
  static constexpr std::array<Node, 8> kNodes = {{{0.095012509837637441, 0.1894506104550685},
                                                  {0.28160355077925892, 0.18260341504492358},
                                                  {0.45801677765722737, 0.16915651939500254},
                                                  {0.61787624440264377, 0.14959598881657674},
                                                  {0.755404408355003, 0.12462897125553388},
                                                  {0.86563120238783176, 0.095158511682492786},
                                                  {0.9445750230732326, 0.062253523938647894},
                                                  {0.98940093499164994, 0.027152459411754096}}};

  Bernstein<double> depth_;
};

}  // namespace tetralux::reference
