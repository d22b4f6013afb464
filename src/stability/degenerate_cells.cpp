#include "stability/degenerate_cells.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "mesh/random.h"

namespace tetralux::stability {
namespace {

constexpr std::uint32_t kColumns = 25;
constexpr std::uint32_t kRows = 20;

struct GridPoint {
  double x, y, depth;  // 0 to 1 in the cell's square, 0 to 1 of the depths' range
};
using GridCell = std::array<GridPoint, 4>;

// Cells in the squares of a picture, row by row.
TetMesh laidOut(const std::vector<GridCell>& cells, const Camera& camera, ImageSize size, std::uint32_t jitterUlp) {
  const double distance = glm::length(camera.center - camera.eye);
  TetMesh mesh;
  std::vector<glm::dvec3> points;
  std::vector<double> values;
  std::uint64_t randomIndex = 0;
  for (std::uint32_t i = 0; i < cells.size(); i++) {
    for (const GridPoint& g : cells[i]) {
      // Binary fractions: under parallel projection coordinates are exact. The 32nds of a pixel keep the
      // centres of pixels more than 1/256 pixel off every line through grid points: a ray along an edge has no one
      // answer.
      const double column = (i % kColumns + 0.125 + 0.75 * g.x) * size.width / kColumns + 15.0 / 32.0;
      const double row = (i / kColumns + 0.125 + 0.75 * g.y) * size.height / kRows + 9.0 / 32.0;
      const Ray ray = camera.pixelRay(size, column, row);
      glm::dvec3 p = ray.origin + distance * (0.875 + 0.25 * g.depth) * ray.direction;
      for (int axis = 0; axis < 3; axis++) {
        const double steps = std::round((2.0 * randomUnit(1, randomIndex++) - 1.0) * jitterUlp);
        p[axis] += steps * 0x1p-23 * std::abs(p[axis]);
      }
      points.push_back(p);
      values.push_back(0.25 * (g.x + g.y) + 0.5 * g.depth);
    }
    mesh.cells.push_back({4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
  }
  mesh.points = std::move(points);
  mesh.pointArrays.push_back({"scalar", 1, std::move(values)});
  mesh.preferredField = "scalar";
  return mesh;
}

double wholeNumber(std::uint64_t index, std::uint32_t count) { return std::floor(randomUnit(2, index) * count); }

}  // namespace

TetMesh degenerateCells(const Camera& camera, ImageSize size, std::uint32_t jitterUlp) {
  std::vector<GridCell> cells;
  std::uint64_t randomIndex = 0;
  const auto point = [&](int i) { return GridPoint{i % 3 / 2.0, i / 3 / 2.0, wholeNumber(randomIndex++, 5) / 4.0}; };
  for (int a = 0; a < 9; a++) {
    for (int b = a; b < 9; b++) {
      for (int c = b; c < 9; c++) {
        for (int d = c; d < 9; d++) cells.push_back({point(a), point(b), point(c), point(d)});
      }
    }
  }
  return laidOut(cells, camera, size, jitterUlp);
}

TetMesh signCells(const Camera& camera, ImageSize size, std::uint32_t jitterUlp) {
  std::vector<GridCell> cells(size_t{kColumns} * kRows);
  std::uint64_t randomIndex = 1000000;
  for (GridCell& cell : cells) {
    for (GridPoint& p : cell) {
      p.x = wholeNumber(randomIndex++, 5) / 4.0;
      p.y = wholeNumber(randomIndex++, 5) / 4.0;
      p.depth = wholeNumber(randomIndex++, 5) / 4.0;
    }
  }
  return laidOut(cells, camera, size, jitterUlp);
}

}  // namespace tetralux::stability
