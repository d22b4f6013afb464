// Scalar to colour and extinction.
#pragma once

#include <string_view>
#include <vector>

#include "volume/optical_model.h"

namespace tetralux {

struct ControlPoint {
  double s = 0.0;
  glm::dvec3 rgb{0.0};  // L or E, linear, >= 0
  double tau = 0.0;     // 1/world unit, >= 0
};

// One linear piece: low <= s <= high, with the values at its own two ends. The first piece of a transfer function
// begins at -infinity and the last ends at +infinity; both are constant.
struct TransferPiece {
  double low = 0.0;
  double high = 0.0;
  OpticalSample atLow;
  OpticalSample atHigh;

  OpticalSample at(double s) const;
};

class TransferFunction {
 public:
  TransferFunction() : TransferFunction({ControlPoint{}}, "transfer function") {}

  // Throws Error(Input) beginning with `place` when there is no point, a number is not finite or negative, or s
  // decreases from one point to the next. Points of equal s make a step.
  TransferFunction(std::vector<ControlPoint> points, std::string_view place,
                   Emission emission = Emission::PerExtinction);

  Emission emission() const { return emission_; }

  const std::vector<ControlPoint>& points() const { return points_; }

  // Pieces of positive width in ascending order, covering all scalars; at least one.
  const std::vector<TransferPiece>& pieces() const { return pieces_; }

  // Index of the piece that holds s; on a boundary, the piece after it.
  size_t pieceIndex(double s) const;

  OpticalSample at(double s) const { return pieces_[pieceIndex(s)].at(s); }

  double largestExtinction() const;

  // Whether no scalar from `low` to `high`, both included, absorbs or emits anything.
  bool isTransparent(double low, double high) const;

  // The same with every extinction multiplied by `factor` >= 0 (the global brightness of Marroquim et al. 2008, section
  // 4.5). Emission per extinction scales with it, emission per length does not. Throws Error(Input) where an extinction
  // becomes infinite.
  TransferFunction scaled(double factor) const;

 private:
  std::vector<ControlPoint> points_;
  std::vector<TransferPiece> pieces_;
  Emission emission_;
};

}  // namespace tetralux
