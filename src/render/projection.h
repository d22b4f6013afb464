// How cells become light in pixels, as a choice.
#pragma once

#include <string>
#include <vector>

namespace tetralux::render {

enum class CellProjection {
  Pt,          // three or four triangles per cell (Shirley and Tuchman 1990; Marroquim et al. 2008)
  Silhouette,  // the outline of the cell; both ends of the ray are found per fragment (Weiler et al. 2003)
  Gator,       // the same triangles as Pt; the vertex shader projects (Wylie et al. 2002)
  March,       // rays walk from cell to cell: no projection, and no order is needed
  Auto,        // chooseProjection()
};

// Names on the command line and in statistics, in the order above; parseProjection throws Error(Usage).
const std::vector<std::string>& projectionNames();
const char* projectionName(CellProjection projection);
CellProjection parseProjection(const std::string& name);

struct ProjectionChoice {
  CellProjection projection = CellProjection::Pt;  // never Auto
  std::string reason;
  double figure = 0.0;  // that it rests on
};

// What CellProjection::Auto becomes. Fans are never the best: on no device that was measured are they faster than
// outlines by more than noise, and where rasterisers interpolate with few bits they err a hundred times more.
//   isWalkable   nothing was asked for that only drawn cells have (an order, a target for blending): rays may walk
ProjectionChoice chooseProjection(bool isWalkable);

}  // namespace tetralux::render
