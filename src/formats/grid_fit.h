#pragma once

#include <string>
#include <vector>

#include "formats/real_drawing.h"
#include "unstep/grid.h"
#include "unstep/result.h"

namespace unstep {

/// Puts what a vector file holds on the grid that holds its vertices: the scale
/// is 1 for whole numbers, the power of two for binary fractions, else the
/// power of ten of the decimals. Vertices that no scale up to kMaxScale holds
/// are rounded to the finest that has room for the coordinates; a note says so.
///
/// Curves become lines within `tolerance` (0: a thousandth of the larger side
/// of the box of all vertices), circular arcs stay arcs whose centre is rounded
/// so finely that they keep within a tenth of it. The drawing has the canvas
/// and paint given.
Result<Drawing> fit_to_grid(RealDrawing& source, const Canvas& canvas,
                            Paint paint, double tolerance,
                            std::vector<std::string>& notes);

}  // namespace unstep
