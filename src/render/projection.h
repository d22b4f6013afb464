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
};

// Names on the command line and in statistics, in the order above; parseProjection throws Error(Usage).
const std::vector<std::string>& projectionNames();
const char* projectionName(CellProjection projection);
CellProjection parseProjection(const std::string& name);

}  // namespace tetralux::render
