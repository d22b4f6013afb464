#include "mesh/delaunay_cells.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/check.h"
#include "base/progress.h"

namespace tetralux {
namespace {

// The vertex at infinity. A ghost cell joins it to a face of the convex hull, so that the cells cover all of space
// and every face has two of them; the hull needs no enclosing tetrahedron, which could not be exact.
constexpr std::uint32_t kInfinite = 0xffffffff;

// A face of a cell: 4 * cell + slot of the vertex opposite to it.
using Facet = std::uint32_t;
constexpr Facet kNoFacet = 0xffffffff;

constexpr std::uint32_t cellOf(Facet facet) { return facet >> 2; }
constexpr std::uint32_t slotOf(Facet facet) { return facet & 3; }
constexpr Facet facetOf(std::uint32_t cell, std::uint32_t slot) { return cell << 2 | slot; }

// Positive by orient3d. A ghost cell is positive with any point beyond its hull face in the place of kInfinite.
struct Cell {
  CellVertices vertices;
  std::array<Facet, 4> across;  // the same face as the neighbour's, opposite to each vertex
};

// Incremental construction (Bowyer 1981; Watson 1981): a new point removes the cells whose circumsphere it lies in,
// and is joined to every face of the hole.
//
// Ties make no difference to the proof that this works. breakCosphericalTie() is the exact test on points whose heights
// on the paraboloid are moved by infinitesimal amounts, so the cells are those of a regular triangulation in general
// position: the hole is star-shaped as seen from the new point, the walk cannot run in circles (the point's power
// falls from cell to cell), and no point is hidden. No flat cell is ever made: a new point in the plane of a face
// sees the same circle through that face from both cells of it (the coefficient of the fourth vertex is 0), so both
// are removed or both stay, and the face is not on the hole's border.
class Triangulation {
 public:
  //   first   vertices of a positive tetrahedron
  Triangulation(const std::vector<GridPoint>& points, const CellVertices& first);

  // Adds a point that is not yet a vertex.
  void insert(std::uint32_t vertex);

  std::vector<CellVertices> finiteCells() const;

 private:
  static constexpr std::uint32_t kNoSlot = 4;

  // kInfinite alone has the highest bit set: there are fewer than 2^31 points.
  static bool isGhost(const CellVertices& v) { return (v[0] | v[1] | v[2] | v[3]) >> 31 != 0; }
  static std::uint32_t slotOfVertex(const CellVertices& v, std::uint32_t vertex) {
    return v[0] == vertex ? 0 : v[1] == vertex ? 1 : v[2] == vertex ? 2 : 3;
  }

  std::int64_t orientReplaced(CellVertices v, std::uint32_t slot, std::uint32_t replacement) const;
  bool inConflict(std::uint32_t cell, std::uint32_t vertex) const;
  std::uint32_t locate(std::uint32_t vertex) const;
  void findHole(std::uint32_t first, std::uint32_t vertex);
  void fillHole(std::uint32_t vertex);
  std::uint32_t newCell(const Cell& cell);

  const std::vector<GridPoint>& points_;
  std::vector<Cell> cells_;
  // Per cell: 2 i if insertion i was the last to look at it, 2 i + 1 if it also removes it.
  std::vector<std::uint32_t> marks_;
  std::uint32_t insertion_ = 0;
  std::uint32_t lastCell_ = 0;  // where the walk starts

  std::vector<std::uint32_t> unusedCells_;
  std::vector<std::uint32_t> hole_;       // cells to remove
  std::vector<Facet> border_;             // their faces towards cells that stay
  std::vector<std::uint32_t> fillCells_;  // the new cell at each of border_
};

Triangulation::Triangulation(const std::vector<GridPoint>& points, const CellVertices& first) : points_(points) {
  constexpr size_t kCellsPerPoint = 7;  // 6.77 for random points (Meijering 1953), less at the border
  CHECK_LT(points.size(), size_t{1} << 31);
  cells_.reserve(points.size() * kCellsPerPoint);
  marks_.reserve(points.size() * kCellsPerPoint);
  const std::uint32_t inner = newCell({first, {}});
  std::array<std::uint32_t, 4> ghosts;
  for (std::uint32_t slot = 0; slot < 4; slot++) {
    // Infinity lies on the other side of the face than the vertex it replaces, so two others change places.
    CellVertices v = first;
    v[slot] = kInfinite;
    std::swap(v[(slot + 1) & 3], v[(slot + 2) & 3]);
    ghosts[slot] = newCell({v, {}});
  }
  for (std::uint32_t slot = 0; slot < 4; slot++) {
    Cell& ghost = cells_[ghosts[slot]];
    cells_[inner].across[slot] = facetOf(ghosts[slot], slot);
    ghost.across[slot] = facetOf(inner, slot);
    for (std::uint32_t other = 0; other < 4; other++) {
      if (other == slot) continue;
      // The two ghosts share infinity and the vertices other than first[slot] and first[other].
      const std::uint32_t there = slotOfVertex(cells_[ghosts[other]].vertices, first[slot]);
      ghost.across[slotOfVertex(ghost.vertices, first[other])] = facetOf(ghosts[other], there);
    }
  }
}

std::uint32_t Triangulation::newCell(const Cell& cell) {
  if (!unusedCells_.empty()) {
    const std::uint32_t index = unusedCells_.back();
    unusedCells_.pop_back();
    cells_[index] = cell;
    return index;
  }
  CHECK_LT(cells_.size(), size_t{1} << 30);
  cells_.push_back(cell);
  marks_.push_back(0);
  return static_cast<std::uint32_t>(cells_.size() - 1);
}

std::int64_t Triangulation::orientReplaced(CellVertices v, std::uint32_t slot, std::uint32_t replacement) const {
  v[slot] = replacement;
  return orient3d(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]);
}

// Whether the point lies inside the cell's circumsphere; for a ghost, beyond its hull face. In the plane of that face
// it is the circle that counts, which the sphere of the cell behind it cuts out of the plane.
bool Triangulation::inConflict(std::uint32_t cell, std::uint32_t vertex) const {
  const CellVertices* v = &cells_[cell].vertices;
  if (isGhost(*v)) {
    const std::uint32_t slot = slotOfVertex(*v, kInfinite);
    const std::int64_t beyond = orientReplaced(*v, slot, vertex);
    if (beyond != 0) return beyond > 0;
    v = &cells_[cellOf(cells_[cell].across[slot])].vertices;
  }
  const auto& [a, b, c, d] = *v;
  return inCircumsphere(points_[a], points_[b], points_[c], points_[d], points_[vertex]);
}

// A cell in conflict with the point: the one that holds it, or a ghost whose hull face it lies beyond. Walks from
// cell to cell through any face that the point lies behind.
std::uint32_t Triangulation::locate(std::uint32_t vertex) const {
  std::uint32_t cell = lastCell_;
  std::uint32_t entered = kNoSlot;
  if (isGhost(cells_[cell].vertices))
    cell = cellOf(cells_[cell].across[slotOfVertex(cells_[cell].vertices, kInfinite)]);
  for (;;) {
    const Cell& here = cells_[cell];
    if (isGhost(here.vertices)) return cell;
    std::uint32_t exit = 0;
    while (exit < 4 && (exit == entered || orientReplaced(here.vertices, exit, vertex) >= 0)) exit++;
    if (exit == 4) return cell;
    entered = slotOf(here.across[exit]);
    cell = cellOf(here.across[exit]);
  }
}

void Triangulation::findHole(std::uint32_t first, std::uint32_t vertex) {
  insertion_++;
  const std::uint32_t stays = 2 * insertion_;
  const std::uint32_t removed = stays + 1;
  hole_.assign(1, first);
  border_.clear();
  marks_[first] = removed;
  for (size_t i = 0; i < hole_.size(); i++) {
    for (std::uint32_t slot = 0; slot < 4; slot++) {
      const std::uint32_t next = cellOf(cells_[hole_[i]].across[slot]);
      if (marks_[next] == removed) continue;
      if (marks_[next] != stays) {
        const bool conflict = inConflict(next, vertex);
        marks_[next] = conflict ? removed : stays;
        if (conflict) hole_.push_back(next);
      }
      if (marks_[next] == stays) border_.push_back(facetOf(hole_[i], slot));
    }
  }
}

void Triangulation::fillHole(std::uint32_t vertex) {
  const std::uint32_t removed = 2 * insertion_ + 1;
  // A new cell is the removed cell at the border with its inner vertex moved to the new point: the same slots, and
  // the same side of the face, hence positive.
  fillCells_.clear();
  for (const Facet face : border_) {
    const Cell& old = cells_[cellOf(face)];
    Cell fill{old.vertices, {kNoFacet, kNoFacet, kNoFacet, kNoFacet}};
    fill.vertices[slotOf(face)] = vertex;
    fill.across[slotOf(face)] = old.across[slotOf(face)];
    const std::uint32_t cell = newCell(fill);
    cells_[cellOf(fill.across[slotOf(face)])].across[slotOf(fill.across[slotOf(face)])] = facetOf(cell, slotOf(face));
    fillCells_.push_back(cell);
  }
  // Two new cells meet across each edge of the border. From one border face at the edge, turn about the edge through
  // the removed cells, which are still whole, to the other.
  for (size_t i = 0; i < border_.size(); i++) {
    for (std::uint32_t slot = 0; slot < 4; slot++) {
      if (cells_[fillCells_[i]].across[slot] != kNoFacet) continue;
      std::uint32_t cell = cellOf(border_[i]);
      std::uint32_t behind = slotOf(border_[i]);  // the face that we come from, and
      std::uint32_t exit = slot;                  // the face that we leave by: the two at the edge
      Facet next = cells_[cell].across[exit];
      while (marks_[cellOf(next)] == removed) {
        const std::uint32_t turned = cells_[cell].vertices[behind];
        cell = cellOf(next);
        behind = slotOf(next);
        exit = slotOfVertex(cells_[cell].vertices, turned);
        next = cells_[cell].across[exit];
      }
      const std::uint32_t other = cellOf(cells_[cellOf(next)].across[slotOf(next)]);  // filled in above
      cells_[fillCells_[i]].across[slot] = facetOf(other, behind);
      cells_[other].across[behind] = facetOf(fillCells_[i], slot);
    }
  }
  for (const std::uint32_t cell : hole_) cells_[cell].vertices[0] = kInfinite;  // finiteCells() leaves them out
  unusedCells_.insert(unusedCells_.end(), hole_.begin(), hole_.end());
  lastCell_ = fillCells_.back();
}

void Triangulation::insert(std::uint32_t vertex) {
  findHole(locate(vertex), vertex);
  fillHole(vertex);
}

std::vector<CellVertices> Triangulation::finiteCells() const {
  const auto finite = [](const Cell& cell) { return !isGhost(cell.vertices); };
  std::vector<CellVertices> cells;
  cells.reserve(static_cast<size_t>(std::count_if(cells_.begin(), cells_.end(), finite)));
  for (const Cell& cell : cells_) {
    if (finite(cell)) cells.push_back(cell.vertices);
  }
  return cells;
}

bool collinear(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  const std::int64_t bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z;
  const std::int64_t cx = c.x - a.x, cy = c.y - a.y, cz = c.z - a.z;
  return by * cz == bz * cy && bz * cx == bx * cz && bx * cy == by * cx;
}

// Four points that make a positive tetrahedron, found in one pass.
CellVertices firstTetrahedron(const std::vector<GridPoint>& points) {
  std::uint32_t third = 2;
  while (third < points.size() && collinear(points[0], points[1], points[third])) third++;
  std::uint32_t fourth = third + 1;
  while (fourth < points.size() && orient3d(points[0], points[1], points[third], points[fourth]) == 0) fourth++;
  if (fourth >= points.size())
    throw CheckFailure(fmt::format("no tetrahedron: {} points at different places, all in one plane", points.size()));
  if (orient3d(points[0], points[1], points[third], points[fourth]) < 0) return {1, 0, third, fourth};
  return {0, 1, third, fourth};
}

}  // namespace

std::vector<CellVertices> delaunayCells(const std::vector<GridPoint>& points) {
  constexpr std::uint32_t kProgressStep = 4096;
  const CellVertices first = firstTetrahedron(points);
  Triangulation triangulation(points, first);
  Progress progress("Delaunay triangulation", points.size());
  for (std::uint32_t i = 0; i < points.size(); i++) {
    if (std::find(first.begin(), first.end(), i) == first.end()) triangulation.insert(i);
    if (i % kProgressStep == 0 && i > 0) progress.advance(kProgressStep);
  }
  return triangulation.finiteCells();
}

}  // namespace tetralux
