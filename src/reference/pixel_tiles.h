// Which cells may cover which part of the picture.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/tet_mesh.h"
#include "view/camera.h"

namespace tetralux::reference {

// Pixels from low to high, both included; empty when low > high.
struct PixelBox {
  std::int32_t lowX = 0, lowY = 0, highX = -1, highY = -1;

  bool empty() const { return lowX > highX || lowY > highY; }
};

// Boxes of pixels whose rays may meet a cell or a triangle, in front of the eye. Never too small; too large only by
// rounding and because it is a box.
class CellFootprint {
 public:
  CellFootprint(const Camera& camera, ImageSize size);
  //   vertices   world; one to four, what is between them counts
  PixelBox operator()(std::span<const glm::dvec3> vertices) const;

 private:
  glm::dmat3 rotation_;
  glm::dvec3 eye_;
  double scale_;
  ImageSize size_;
  bool perspective_;
};

class PixelCounts;

// Square tiles of the image, each with the list of cells whose footprint holds a wanted pixel and reaches the tile; or
// of other things that have a box of pixels.
class PixelTiles {
 public:
  static constexpr std::int32_t kSide = 16;  // pixels

  //   wanted   the pixels of interest; null: all are
  PixelTiles(const TetMesh& mesh, const CellFootprint& footprint, ImageSize size, const PixelCounts* wanted);

  //   boxOf   of thing 0 to count - 1: a box inside the image, or an empty one; called from several threads
  PixelTiles(size_t count, const std::function<PixelBox(size_t)>& boxOf, ImageSize size);

  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return rows_; }
  static std::uint32_t columnsOf(ImageSize size) { return (size.width + kSide - 1) / kSide; }
  static std::uint32_t rowsOf(ImageSize size) { return (size.height + kSide - 1) / kSide; }

  // Cells, or things, of a tile, ascending.
  std::span<const std::uint32_t> cells(std::uint32_t tile) const;

 private:
  std::uint32_t columns_;
  std::uint32_t rows_;
  std::vector<std::uint64_t> starts_;  // tiles + 1
  std::vector<std::uint32_t> cells_;
};

// The four corners of a cell, world.
std::array<glm::dvec3, 4> cellVertices(const TetMesh& mesh, size_t cell);

// The scalars there; a cell's own value four times.
std::array<double, 4> cellScalars(const TetMesh& mesh, const ScalarField& field, size_t cell);

}  // namespace tetralux::reference
