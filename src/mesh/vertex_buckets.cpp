#include "mesh/vertex_buckets.h"

namespace tetralux {

CellVertices sortedVertices(CellVertices v) {
  const auto order = [&v](size_t a, size_t b) {
    if (v[b] < v[a]) std::swap(v[a], v[b]);
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  return v;
}

}  // namespace tetralux
