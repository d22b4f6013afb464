// Names beside points, so that none hides another.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tetralux::chart {

struct Rect {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;  // pixels, y down

  bool overlaps(const Rect& other) const;
  bool contains(const Rect& other) const;
};

// Width of a text in the charts' font, roughly, pixels.
double textWidth(const std::string& text, double fontPixels);

struct Segment {
  double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;  // pixels

  bool crosses(const Rect& rect) const;
  bool crosses(const Segment& other) const;
};

struct LabelRequest {
  double x = 0.0, y = 0.0;  // of the point, pixels
  std::string text;
  bool isImportant = false;  // placed first
};

struct PlacedLabel {
  Rect rect;
  // Where a line from the point to the label ends, where the label is not right beside it.
  std::optional<std::pair<double, double>> leaderEnd;
};

// A place for every label within the area that covers no point, no other label and none of the obstacles: beside its
// point where there is room, else further away, with a leader. Leaders cross nothing either, if that can be had.
// Nothing for a label that finds no place. Same input, same result.
//   obstacles    straight lines that labels should not cover
//   fontPixels   size of the font
//   radius       of the points' marks, pixels
std::vector<std::optional<PlacedLabel>> placeLabels(const std::vector<LabelRequest>& requests, const Rect& area,
                                                    const std::vector<Segment>& obstacles, double fontPixels,
                                                    double radius);

// Moves positions apart so that neighbours are at least `gap` apart and all lie within [low, high]
// where that is possible; order is kept and moves are small. For labels at the ends of lines.
std::vector<double> spreadApart(const std::vector<double>& positions, double gap, double low, double high);

}  // namespace tetralux::chart
