// Segments alone: groups 1, 2, 3, 5, 6 and 7 of the list that docs/stability.md explains.
#include <algorithm>
#include <cmath>

#include "stability/region.h"

namespace tetralux::stability {
namespace {

TransferFunction ramp(double tauLow, double tauHigh) {
  return TransferFunction({{0.0, {1.0, 0.0, 0.5}, tauLow}, {1.0, {0.0, 1.0, 0.5}, tauHigh}}, "ramp");
}

std::vector<Segment> overLengths(double lowExponent, double highExponent, double step) {
  std::vector<Segment> segments;
  for (double exponent = lowExponent; exponent <= highExponent; exponent += step) {
    const double length = std::pow(10.0, exponent);
    segments.push_back({0.0, 1.0, length});
    segments.push_back({1.0, 0.0, length});
    segments.push_back({0.3, 0.3, length});
    segments.push_back({0.3, 0.3 + 1e-6, length});
  }
  return segments;
}

// Depths a and b at the two ends from 1e-8 to 1e8: every pair of the grid in steps of a decade's quarter along the
// length, with end extinctions equal, nearly equal, decades apart, and zero.
RegionCases depthGrid() {
  RegionCases cases;
  for (const double ratio : {0.0, 1e-8, 1e-4, 1e-1, 1.0 - 1e-6, 1.0, 1.0 + 1e-6, 1e1, 1e4, 1e8})
    cases.segments.push_back({"ratio", ramp(1.0, ratio), overLengths(-8.0, 8.0, 0.25)});
  return cases;
}

// Where forms meet that agree on paper: optical depth 1/2 and 1, and equal ends.
RegionCases seams() {
  RegionCases cases;
  for (const double depth : {0.5, 1.0}) {
    std::vector<Segment> segments;
    for (int i = -64; i <= 64; i++) {
      const double length = depth * (1.0 + i * 0x1p-24);
      segments.push_back({0.25, 0.75, length});
      segments.push_back({0.5, 0.5 + i * 0x1p-22, length});
    }
    cases.segments.push_back({"depth", ramp(0.5, 1.5), segments});
  }
  return cases;
}

RegionCases equalColors() {
  const TransferFunction transfer(
      {{0.0, {0.3, 0.6, 0.9}, 0.1}, {0.4, {0.3, 0.6, 0.9}, 7.0}, {1.0, {0.3, 0.6, 0.9}, 0.0}}, "equal");
  RegionCases cases;
  std::vector<Segment> segments = overLengths(-8.0, 4.0, 0.5);
  for (const double s : {0.0, 0.2, 0.4, 1.0}) segments.push_back({s, 1.0 - s, 0.0});
  cases.segments.push_back({"equal", transfer, segments});
  return cases;
}

RegionCases opaque() {
  RegionCases cases;
  for (const auto& [front, back] : {std::pair(0.0, 1e6), std::pair(1e6, 0.0), std::pair(1e6, 1e6)})
    cases.segments.push_back({"opaque", ramp(front, back), {{0.0, 1.0, 1.0}, {0.0, 0.5, 1.0}, {0.5, 1.0, 1.0}}});
  return cases;
}

// A peak of 1 % of the range, a gap, a step: ends on, beside and across every control point, both ways.
RegionCases controlPoints() {
  // Multiples of 1/256: exact on the device as well.
  const TransferFunction transfer({{0.0, {0.1, 0.2, 0.9}, 0.0},
                                   {76 / 256.0, {0.1, 0.2, 0.9}, 0.0},
                                   {77 / 256.0, {0.9, 0.2, 0.1}, 9.0},
                                   {78 / 256.0, {0.1, 0.2, 0.9}, 0.0},
                                   {204 / 256.0, {1.0, 1.0, 1.0}, 0.2},
                                   {204 / 256.0, {0.0, 0.0, 0.0}, 3.0},
                                   {1.0, {1.0, 0.0, 0.0}, 5.0}},
                                  "control points");
  std::vector<Segment> segments;
  for (const ControlPoint& p : transfer.points()) {
    for (const double offset : {0.0, 1e-7, -1e-7, 1e-5, -1e-5, 1e-3, -1e-3}) {
      for (const double other : {0.0, 1e-8, -1e-8, 1e-7, -1e-7, 1e-4, -1e-4, 0.2, -0.2, 1.0, -1.0}) {
        const double front = std::clamp(p.s + offset, 0.0, 1.0);
        segments.push_back({front, std::clamp(front + other, 0.0, 1.0), 2.0});
      }
    }
  }
  RegionCases cases;
  cases.segments.push_back({"control points", transfer, segments});
  return cases;
}

}  // namespace

std::vector<Region> segmentRegions() {
  return {{"depth grid", "segments: optical depths at both ends from 1e-8 to 1e8", depthGrid},
          {"seams", "segments: where two closed forms meet", seams},
          {"equal colours", "segments: one colour everywhere, and no length", equalColors},
          {"opaque ends", "segments: optical depth 1e6 at one end or both", opaque},
          {"control points", "segments: ends on, beside and across control points", controlPoints}};
}

}  // namespace tetralux::stability
