// Which integration the cells of a mesh need (tolerance/classify.comp).
#ifndef TETRALUX_SHARED_CELL_CLASSES_H
#define TETRALUX_SHARED_CELL_CLASSES_H

#include "types.h"

SHARED_BEGIN

struct CellClassCounts {
  uint empty;        // neither absorb nor emit
  uint average;      // the mean scalar's colour is within the limit
  uint linear;       // no control point inside, but the mean's colour is not
  uint pieces;       // control points inside
  uint worstMean;    // bits of a float: largest bound of the mean colour's error, relative to the opacity, of cells without
                     // control points inside
  uint worstChange;  // bits of a float: largest change of luminance within a piece inside a cell
};

SHARED_END

#endif
