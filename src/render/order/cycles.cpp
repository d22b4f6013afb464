#include "render/order/cycles.h"

#include <algorithm>

#include "shared/limits.h"
#include "shared/pixel_lists.h"

namespace tetralux::render {
namespace {

// Every step of compositing apart goes over the picture once. Where there are more levels with cycles than this,
// neighbouring ones are composited together with what lies between them.
constexpr size_t kMostSteps = 32;

// The cells that are left, numbered densely, with the cells in front of each.
struct FrontGraph {
  std::vector<std::uint32_t> cells;
  std::vector<std::uint32_t> firstEdge;  // one more than cells
  std::vector<std::uint32_t> edges;      // dense numbers

  std::uint32_t size() const { return static_cast<std::uint32_t>(cells.size()); }
};

bool isLeft(std::uint32_t state) { return state != shared::WAIT_ABSENT && (state & shared::WAIT_PEELED) == 0; }

FrontGraph makeGraph(const PeelRemains& remains) {
  FrontGraph graph;
  std::vector<std::uint32_t> number(remains.waiting.size());
  for (std::uint32_t cell = 0; cell < remains.waiting.size(); cell++) {
    if (!isLeft(remains.waiting[cell])) continue;
    number[cell] = graph.size();
    graph.cells.push_back(cell);
  }
  graph.firstEdge.reserve(graph.cells.size() + 1);
  for (const std::uint32_t cell : graph.cells) {
    graph.firstEdge.push_back(static_cast<std::uint32_t>(graph.edges.size()));
    const std::uint32_t state = remains.waiting[cell];
    for (std::uint32_t k = 0; k < 4; k++) {
      if ((state >> (shared::WAIT_FRONT_SHIFT + k) & 1) != 0) graph.edges.push_back(number[remains.neighbors[cell][k]]);
    }
    if (remains.relationHeads.empty() || (state & shared::WAIT_RELATED) == 0) continue;
    for (std::uint32_t i = remains.relationHeads[cell]; i != shared::NO_NODE; i = remains.relations[i].next)
      graph.edges.push_back(number[remains.relations[i].cell]);
  }
  graph.firstEdge.push_back(static_cast<std::uint32_t>(graph.edges.size()));
  return graph;
}

// Strongly connected components, numbered so that edges lead from higher to lower numbers.
struct Components {
  std::vector<std::uint32_t> of;  // per cell of the graph
  std::vector<std::uint32_t> sizes;
};

// Tarjan 1972, with a stack of its own instead of recursion.
Components findComponents(const FrontGraph& graph) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  const std::uint32_t count = graph.size();
  Components result;
  result.of.assign(count, kNone);
  std::vector<std::uint32_t> index(count, kNone);
  std::vector<std::uint32_t> low(count);
  std::vector<std::uint32_t> nextEdge(graph.firstEdge.begin(), graph.firstEdge.end() - 1);
  std::vector<std::uint32_t> open;  // visited, without a component yet
  std::vector<std::uint32_t> path;
  std::uint32_t visited = 0;
  for (std::uint32_t root = 0; root < count; root++) {
    if (index[root] != kNone) continue;
    path.push_back(root);
    while (!path.empty()) {
      const std::uint32_t cell = path.back();
      if (index[cell] == kNone) {
        index[cell] = low[cell] = visited++;
        open.push_back(cell);
      }
      bool isDeeper = false;
      while (nextEdge[cell] < graph.firstEdge[cell + 1]) {
        const std::uint32_t front = graph.edges[nextEdge[cell]];
        if (index[front] == kNone) {
          path.push_back(front);
          isDeeper = true;
          break;
        }
        if (result.of[front] == kNone) low[cell] = std::min(low[cell], low[front]);
        nextEdge[cell]++;
      }
      if (isDeeper) continue;
      path.pop_back();
      if (low[cell] != index[cell]) continue;
      std::uint32_t size = 0;
      std::uint32_t member = kNone;
      do {
        member = open.back();
        open.pop_back();
        result.of[member] = static_cast<std::uint32_t>(result.sizes.size());
        size++;
      } while (member != cell);
      result.sizes.push_back(size);
    }
  }
  return result;
}

// Levels of components: one more than the highest behind.
std::vector<std::uint32_t> findLevels(const FrontGraph& graph, const Components& components) {
  // Cells by component, those behind (of higher number) first.
  std::vector<std::uint32_t> cells(graph.size());
  for (std::uint32_t i = 0; i < graph.size(); i++) cells[i] = i;
  std::stable_sort(cells.begin(), cells.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return components.of[a] > components.of[b]; });
  std::vector<std::uint32_t> levels(components.sizes.size(), 0);
  for (const std::uint32_t cell : cells) {
    const std::uint32_t component = components.of[cell];
    for (std::uint32_t e = graph.firstEdge[cell]; e < graph.firstEdge[cell + 1]; e++) {
      const std::uint32_t front = components.of[graph.edges[e]];
      if (front != component) levels[front] = std::max(levels[front], levels[component] + 1);
    }
  }
  return levels;
}

// Keys, relative to the first one that is free, that are composited apart: [first, last].
struct KeyRange {
  std::uint32_t first, last;
};

std::vector<KeyRange> apartKeys(std::vector<std::uint32_t> cyclicKeys) {
  std::sort(cyclicKeys.begin(), cyclicKeys.end());
  cyclicKeys.erase(std::unique(cyclicKeys.begin(), cyclicKeys.end()), cyclicKeys.end());
  const size_t perStep = (cyclicKeys.size() + kMostSteps - 1) / kMostSteps;
  std::vector<KeyRange> ranges;
  for (size_t i = 0; i < cyclicKeys.size(); i += perStep)
    ranges.push_back({cyclicKeys[i], cyclicKeys[std::min(i + perStep, cyclicKeys.size()) - 1]});
  return ranges;
}

}  // namespace

CycleReport resolveCycles(const PeelRemains& remains, std::span<std::uint32_t> keys) {
  const FrontGraph graph = makeGraph(remains);
  const Components components = findComponents(graph);
  const std::vector<std::uint32_t> levels = findLevels(graph, components);

  // Even keys for the levels' single cells, odd ones for their cycles.
  CycleReport report;
  std::vector<std::uint32_t> cyclicKeys;
  std::vector<std::uint32_t> newKeys(graph.size());
  std::uint32_t largest = 0;
  for (std::uint32_t i = 0; i < graph.size(); i++) {
    const std::uint32_t component = components.of[i];
    const bool isCyclic = components.sizes[component] > 1;
    newKeys[i] = 2 * levels[component] + (isCyclic ? 1 : 0);
    largest = std::max(largest, newKeys[i]);
    if (!isCyclic) continue;
    report.cyclicCells++;
    cyclicKeys.push_back(newKeys[i]);
  }
  const std::vector<KeyRange> ranges = apartKeys(std::move(cyclicKeys));
  for (std::uint32_t& key : newKeys) {
    const auto range =
        std::partition_point(ranges.begin(), ranges.end(), [&](const KeyRange& r) { return r.last < key; });
    if (range == ranges.end() || key < range->first) continue;
    key = range->first;
    report.apartCells++;
  }

  std::vector<std::uint32_t> drawnPerKey(largest + 1, 0);
  for (std::uint32_t i = 0; i < graph.size(); i++) {
    std::uint32_t& key = keys[graph.cells[i]];
    const std::uint32_t transparent = key & shared::KEY_TRANSPARENT;
    key = transparent | (remains.levelCount + newKeys[i]);
    if (transparent == 0) drawnPerKey[newKeys[i]]++;
  }
  const auto drawnAll = static_cast<std::uint32_t>(
      std::count_if(keys.begin(), keys.end(), [](std::uint32_t key) { return key < shared::KEY_TRANSPARENT; }));
  std::uint32_t drawnLeft = 0;
  for (const std::uint32_t count : drawnPerKey) drawnLeft += count;
  std::uint32_t slot = drawnAll - drawnLeft;
  auto range = ranges.begin();
  for (std::uint32_t key = 0; key <= largest; key++) {
    if (range != ranges.end() && key == range->first) {
      if (drawnPerKey[key] > 0) report.apart.push_back({slot, slot + drawnPerKey[key]});
      ++range;
    }
    slot += drawnPerKey[key];
  }
  report.largestKey = remains.levelCount + largest;
  return report;
}

}  // namespace tetralux::render
