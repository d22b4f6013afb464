// Horizontal bars: one number per name, split into a base and what comes on top.
#pragma once

#include <string>
#include <vector>

namespace tetralux::chart {

struct Bar {
  std::string name;
  double base = 0.0;
  double total = 0.0;  // >= base
};

// An SVG with a bar per entry: the base in one colour, the rest in another, and the growth in percent beside it.
//   title       of the chart
//   baseText    what the base is
//   totalText   what base and rest together are
std::string barsSvg(const std::string& title, const std::string& baseText, const std::string& totalText,
                    const std::vector<Bar>& bars);

}  // namespace tetralux::chart
