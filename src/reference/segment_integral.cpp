#include "reference/segment_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>

namespace tetralux::reference {
namespace {

// Gauss-Legendre with 10 points on [-1, 1] (Abramowitz and Stegun 1964, table 25.4): five pairs.
struct Node {
  double x, weight;
};
constexpr std::array<Node, 5> kNodes = {{{0.14887433898163122, 0.29552422471475287},
                                         {0.43339539412924719, 0.26926671930999636},
                                         {0.67940956829902441, 0.21908636251598204},
                                         {0.86506336668898451, 0.14945134915058059},
                                         {0.97390652851717172, 0.06667134430868814}}};

// A panel of the quadrature absorbs at most this optical depth; the 10-point rule then errs by less than 1e-16.
constexpr double kPanelDepth = 0.5;

// exp(-45) is 3e-20: nothing behind it shows in double precision.
constexpr double kOpaqueDepth = 45.0;

// Integrates over a linear piece, u from 0 at its front to 1, in panels of equal optical depth as far as light gets.
//   integrand   of u and the transmittance from the front to u
template <typename Value, typename Integrand>
Value integratePiece(double depthFront, double depthBack, Value sum, const Integrand& integrand) {
  const double slope = depthBack - depthFront;
  const double total = 0.5 * (depthFront + depthBack);
  // u at which the optical depth from the front is T: the root of slope u^2/2 + depthFront u = T that does not cancel.
  const auto inverse = [&](double T) {
    const double root = std::sqrt(std::max(0.0, depthFront * depthFront + 2.0 * slope * T));
    return std::min(1.0, 2.0 * T / (depthFront + root));
  };
  const double reach = std::min(total, kOpaqueDepth);
  const int panels = std::max(1, static_cast<int>(std::ceil(reach / kPanelDepth)));
  double u0 = 0.0;
  for (int k = 1; k <= panels; k++) {
    const double u1 = k == panels && reach == total ? 1.0 : inverse(reach * k / panels);
    const double half = 0.5 * (u1 - u0);
    const double middle = 0.5 * (u1 + u0);
    const auto at = [&](double u) { return integrand(u, std::exp(-u * (depthFront + 0.5 * slope * u))); };
    for (const Node& node : kNodes)
      sum += half * node.weight * (at(middle - half * node.x) + at(middle + half * node.x));
    u0 = u1;
  }
  return sum;
}

}  // namespace

double emissionMoment(double depthFront, double depthBack) {
  if (!(depthFront + depthBack > 0.0)) return 0.0;
  return integratePiece(depthFront, depthBack, 0.0, [&](double u, double transmittance) {
    return u * (depthFront + (depthBack - depthFront) * u) * transmittance;
  });
}

LengthMoments lengthMoments(double depthFront, double depthBack) {
  const glm::dvec2 sum = integratePiece(depthFront, depthBack, glm::dvec2(0.0), [](double u, double transmittance) {
    return glm::dvec2(transmittance, u * transmittance);
  });
  return {sum.x, sum.y};
}

SegmentOptics integrateSegment(const TransferFunction& transfer, double sFront, double sBack, double length) {
  SegmentOptics result;
  double transmittance = 1.0;
  const auto addPiece = [&](const OpticalSample& front, const OpticalSample& back, double pieceLength) {
    const double depthFront = front.extinction * pieceLength;
    const double depthBack = back.extinction * pieceLength;
    const double alpha = -std::expm1(-0.5 * (depthFront + depthBack));
    const glm::dvec3 change = back.luminance - front.luminance;
    glm::dvec3 light;
    if (transfer.emission() == Emission::PerLength) {
      const LengthMoments moments = lengthMoments(depthFront, depthBack);
      light = pieceLength * (front.luminance * moments.even + change * moments.linear);
    } else {
      light = front.luminance * alpha;
      if (change != glm::dvec3(0.0)) light += change * emissionMoment(depthFront, depthBack);
    }
    result.light += transmittance * light;
    transmittance *= 1.0 - alpha;
    result.alpha += (1.0 - result.alpha) * alpha;
  };

  const auto& pieces = transfer.pieces();
  const double rise = sBack - sFront;
  size_t piece = transfer.pieceIndex(sFront);
  if (rise == 0.0) {
    const OpticalSample sample = pieces[piece].at(sFront);
    addPiece(sample, sample, length);
    return result;
  }
  double s = sFront;
  for (;;) {
    const bool rising = rise > 0.0;
    const double boundary = rising ? pieces[piece].high : pieces[piece].low;
    const double next = rising ? std::min(boundary, sBack) : std::max(boundary, sBack);
    addPiece(pieces[piece].at(s), pieces[piece].at(next), length * ((next - s) / rise));
    if (next == sBack) return result;
    s = next;
    piece = rising ? piece + 1 : piece - 1;
  }
}

}  // namespace tetralux::reference
