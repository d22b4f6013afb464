// Outcomes as a picture: a heat map of methods by regions.
#pragma once

#include <span>
#include <string>

#include "stability/run.h"

namespace tetralux::stability {

// A picture (SVG 1.1): a row per region and a column per method, in the order in which they first come; a cell's colour
// is the largest error on a logarithmic scale, its text the same to one digit. A frame marks a strict method beyond its
// limits, a dash a method that does not apply.
//   device   named in the title
std::string failureMapSvg(std::span<const Outcome> outcomes, const std::string& device);

// The same picture in a page by itself, with a table of the figures behind it. Refers to no other file.
std::string failureMapHtml(std::span<const Outcome> outcomes, const std::string& device);

}  // namespace tetralux::stability
