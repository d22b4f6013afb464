#include "render/memory_need.h"

#include <algorithm>

#include "shared/limits.h"

namespace tetralux::render {

std::uint64_t leastMeshBytes(std::uint64_t cells, std::uint64_t points, FieldAssociation association,
                             CellProjection projection, bool hasFloat64) {
  std::uint64_t bytes = 16 * cells + 16 * points;  // gpu_mesh.h
  if (association == FieldAssociation::Cell) bytes += 4 * cells;
  if (projection == CellProjection::March)
    return bytes + 32 * cells + cells / 8 + (hasFloat64 ? 16 * points : 0);  // walk_topology.h, march_storage.h
  bytes += 16 * cells;                                                       // sort_pass.h
  const std::uint64_t batch = std::min<std::uint64_t>(cells, shared::BATCH_CELLS);
  bytes += batch * 4 * (projection == CellProjection::Silhouette ? shared::OUTLINE_INDICES : shared::FAN_INDICES);
  if (projection != CellProjection::Gator) bytes += batch * (24 * shared::FAN_VERTICES + 4);  // batch.h
  return bytes;
}

}  // namespace tetralux::render
