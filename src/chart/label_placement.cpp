#include "chart/label_placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace tetralux::chart {
namespace {

constexpr double kMargin = 1.5;  // between labels, pixels

// Characters of UTF-8: continuation bytes take no room.
size_t characterCount(const std::string& text) {
  return static_cast<size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }));
}

// Places where a label of this size may lie, nearest first.
std::vector<PlacedLabel> candidates(const LabelRequest& request, double width, double height, double radius) {
  std::vector<PlacedLabel> result;
  const double near = radius + 3.0;
  const auto add = [&](double x, double y, bool hasLeader, double endX, double endY) {
    PlacedLabel label{{x, y, width, height}, std::nullopt};
    if (hasLeader) label.leaderEnd = {endX, endY};
    result.push_back(label);
  };
  add(request.x + near, request.y - height / 2, false, 0, 0);
  add(request.x - near - width, request.y - height / 2, false, 0, 0);
  add(request.x - width / 2, request.y - near - height, false, 0, 0);
  add(request.x - width / 2, request.y + near, false, 0, 0);
  for (const double distance : {14.0, 22.0, 32.0, 44.0, 58.0, 76.0, 96.0, 120.0, 150.0, 185.0, 225.0}) {
    constexpr int kDirections = 36;
    for (int i = 0; i < kDirections; i++) {
      const double angle = 2.0 * std::numbers::pi * i / kDirections;
      const double x = request.x + distance * std::cos(angle);
      const double y = request.y - distance * std::sin(angle);
      // The leader ends at the middle of the label's nearer side.
      const bool toTheRight = std::cos(angle) >= 0.0;
      add(toTheRight ? x : x - width, y - height / 2, true, toTheRight ? x - 1 : x + 1, y);
    }
  }
  return result;
}

class Placement {
 public:
  Placement(const std::vector<LabelRequest>& requests, const Rect& area, const std::vector<Segment>& obstacles,
            double radius)
      : requests_(requests), area_(area), obstacles_(obstacles), radius_(radius) {}

  std::optional<PlacedLabel> place(const LabelRequest& request, double width, double height) {
    for (const bool isStrict : {true, false}) {
      for (const PlacedLabel& candidate : candidates(request, width, height, radius_)) {
        if (!isFree(request, candidate, isStrict)) continue;
        labels_.push_back(candidate.rect);
        if (candidate.leaderEnd) leaders_.push_back(leaderOf(request, candidate));
        return candidate;
      }
    }
    return std::nullopt;
  }

 private:
  static Segment leaderOf(const LabelRequest& request, const PlacedLabel& label) {
    return {request.x, request.y, label.leaderEnd->first, label.leaderEnd->second};
  }

  // Without `isStrict` lines may cross.
  bool isFree(const LabelRequest& request, const PlacedLabel& candidate, bool isStrict) const {
    const Rect& rect = candidate.rect;
    const Rect wide{rect.x - kMargin, rect.y - kMargin, rect.width + 2 * kMargin, rect.height + 2 * kMargin};
    if (!area_.contains(rect)) return false;
    const auto hits = [&](const auto& obstacles, const auto& test) {
      return std::any_of(obstacles.begin(), obstacles.end(), test);
    };
    if (hits(requests_, [&](const LabelRequest& r) {
          return wide.overlaps({r.x - radius_, r.y - radius_, 2 * radius_, 2 * radius_});
        }))
      return false;
    if (hits(labels_, [&](const Rect& label) { return wide.overlaps(label); })) return false;
    if (hits(leaders_, [&](const Segment& leader) { return leader.crosses(wide); })) return false;
    if (!isStrict) return true;
    if (hits(obstacles_, [&](const Segment& obstacle) { return obstacle.crosses(wide); })) return false;
    if (!candidate.leaderEnd) return true;
    const Segment own = leaderOf(request, candidate);
    return !hits(labels_, [&](const Rect& label) { return own.crosses(label); }) &&
           !hits(leaders_, [&](const Segment& leader) { return own.crosses(leader); });
  }

  const std::vector<LabelRequest>& requests_;
  Rect area_;
  const std::vector<Segment>& obstacles_;
  double radius_;
  std::vector<Rect> labels_;
  std::vector<Segment> leaders_;
};

}  // namespace

bool Rect::overlaps(const Rect& other) const {
  return x < other.x + other.width && other.x < x + width && y < other.y + other.height && other.y < y + height;
}

bool Rect::contains(const Rect& other) const {
  return other.x >= x && other.y >= y && other.x + other.width <= x + width && other.y + other.height <= y + height;
}

bool Segment::crosses(const Rect& rect) const {
  constexpr int kSteps = 200;  // labels are a few pixels high, lines at most a thousand long
  for (int i = 0; i <= kSteps; i++) {
    const double t = static_cast<double>(i) / kSteps;
    const double x = x0 + t * (x1 - x0);
    const double y = y0 + t * (y1 - y0);
    if (x > rect.x && x < rect.x + rect.width && y > rect.y && y < rect.y + rect.height) return true;
  }
  return false;
}

bool Segment::crosses(const Segment& other) const {
  const auto side = [](const Segment& l, double x, double y) {
    return (l.x1 - l.x0) * (y - l.y0) - (l.y1 - l.y0) * (x - l.x0);
  };
  return side(*this, other.x0, other.y0) * side(*this, other.x1, other.y1) < 0.0 &&
         side(other, x0, y0) * side(other, x1, y1) < 0.0;
}

double textWidth(const std::string& text, double fontPixels) {
  return 0.6 * fontPixels * static_cast<double>(characterCount(text));
}

std::vector<std::optional<PlacedLabel>> placeLabels(const std::vector<LabelRequest>& requests, const Rect& area,
                                                    const std::vector<Segment>& obstacles, double fontPixels,
                                                    double radius) {
  std::vector<size_t> order(requests.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](size_t i) { return requests[i].isImportant; });
  Placement placement(requests, area, obstacles, radius);
  std::vector<std::optional<PlacedLabel>> placed(requests.size());
  for (const size_t i : order) {
    if (requests[i].text.empty()) continue;
    placed[i] = placement.place(requests[i], textWidth(requests[i].text, fontPixels), fontPixels + 2.0);
  }
  return placed;
}

std::vector<double> spreadApart(const std::vector<double>& positions, double gap, double low, double high) {
  std::vector<size_t> order(positions.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return positions[a] < positions[b]; });
  // Groups of neighbours that touch move as one, to the mean of where their members would like to be.
  struct Group {
    double sum = 0.0;  // of wanted positions of the group's first member
    size_t count = 0;
    double first() const { return sum / static_cast<double>(count); }
  };
  std::vector<Group> groups;
  for (const size_t i : order) {
    groups.push_back({positions[i], 1});
    while (groups.size() > 1) {
      const Group& last = groups.back();
      Group& before = groups[groups.size() - 2];
      const double length = gap * static_cast<double>(before.count);
      if (before.first() + length <= last.first()) break;
      before.sum += last.sum - length * static_cast<double>(last.count);
      before.count += last.count;
      groups.pop_back();
    }
  }
  std::vector<double> result(positions.size());
  size_t at = 0;
  double end = low - gap;
  for (const Group& group : groups) {
    const double length = gap * static_cast<double>(group.count - 1);
    const double first = std::max(std::min(group.first(), high - length), end + gap);
    for (size_t k = 0; k < group.count; k++) result[order[at++]] = first + gap * static_cast<double>(k);
    end = first + length;
  }
  return result;
}

}  // namespace tetralux::chart
