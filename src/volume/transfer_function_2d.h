// Scalar and gradient magnitude to colour and extinction (Kindlmann and Durkin 1998; Kniss, Kindlmann and Hansen 2002).
#pragma once

#include <string_view>
#include <vector>

#include "volume/optical_model.h"

namespace tetralux {

// Samples on a grid, bilinear in between, constant outside in either direction.
class TransferFunction2d {
 public:
  // Throws Error(Input) beginning with `place` when an axis is empty or does not ascend strictly, the number of samples
  // is not the product of both axes' lengths, or a number is not finite or a sample's is negative.
  //   samples   sample of scalar i and gradient j at i + j * scalars.size()
  TransferFunction2d(std::vector<double> scalars, std::vector<double> gradients, std::vector<OpticalSample> samples,
                     std::string_view place);

  const std::vector<double>& scalars() const { return scalars_; }
  const std::vector<double>& gradients() const { return gradients_; }
  const std::vector<OpticalSample>& samples() const { return samples_; }
  OpticalSample at(double scalar, double gradient) const;
  double largestExtinction() const;

 private:
  std::vector<double> scalars_;
  std::vector<double> gradients_;
  std::vector<OpticalSample> samples_;
};

}  // namespace tetralux
