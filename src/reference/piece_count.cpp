#include "reference/piece_count.h"

#include <algorithm>

namespace tetralux::reference {

std::uint32_t pieceCount(const TransferFunction& transfer, double a, double b) {
  const double low = std::min(a, b);
  const double high = std::max(a, b);
  const size_t first = transfer.pieceIndex(low);
  size_t last = transfer.pieceIndex(high);
  // A range that ends on a control point does not reach into the piece after it.
  if (last > first && transfer.pieces()[last].low == high) last--;
  return static_cast<std::uint32_t>(last - first + 1);
}

std::uint64_t cellPieceCount(const TetMesh& mesh, const ScalarField& field, const TransferFunction& transfer) {
  if (field.association == FieldAssociation::Cell) return mesh.cellCount();
  std::uint64_t count = 0;
  for (const CellVertices& cell : mesh.cells) {
    const auto [low, high] =
        std::minmax({field.values[cell[0]], field.values[cell[1]], field.values[cell[2]], field.values[cell[3]]});
    count += pieceCount(transfer, low, high);
  }
  return count;
}

}  // namespace tetralux::reference
