// One axis of a chart: its range, its ticks, and where values lie on it.
#pragma once

#include <string>
#include <vector>

namespace tetralux::chart {

struct Tick {
  double value = 0.0;
  std::string text;  // empty: a fine line without a number
};

// Logarithmic or linear range with ticks at round values.
class Axis {
 public:
  // A range that holds all values, with a little room, and ends at round ones: 1, 2, 5 times powers of ten. Where a
  // logarithmic one spans more than three decades only powers of ten have numbers. Of a logarithmic axis only values
  // above 0 count. Without any the range is 1 to 10, or 0 to 1.
  static Axis logarithmic(const std::vector<double>& values);
  static Axis linearFromZero(const std::vector<double>& values);

  // A logarithmic axis from the smallest to the largest of these ticks, with a little room at both ends. At least one.
  static Axis logarithmicAt(std::vector<Tick> ticks);

  double low() const { return low_; }
  double high() const { return high_; }
  bool isLogarithmic() const { return isLogarithmic_; }
  const std::vector<Tick>& ticks() const { return ticks_; }  // ascending

  // Share of the way from low to high; outside [0, 1] for values beyond.
  double share(double value) const;

 private:
  double low_ = 0.0;
  double high_ = 1.0;
  bool isLogarithmic_ = false;
  std::vector<Tick> ticks_;
};

}  // namespace tetralux::chart
