#pragma once

#include <cstdint>

#include "render/sub_grid.h"
#include "unstep/bitmap.h"

/// Lines on rasters; ends are in sub-units, y down. Pixel (x, y) covers the
/// grid unit between (x, y) and (x + 1, y + 1). Time is bounded by the rows
/// (and columns) of the raster, whatever the ends are.
namespace unstep::render {

/// Flips the first pixel of every row whose centre is right of, or on, the
/// line, if the row's centres are between the ends (the lower one included, the
/// upper one not). Parity from left to right then fills polygons.
void flip_crossings(Place from, Place to, const SubGrid& grid, Bitmap& pixels);

/// Inks the pixels of an 8-connected line: one per column, or row if the line
/// is steeper, from the point of the grid nearest to `from` to that nearest to
/// `to`. Here pixel (x, y) stands for the point (x, y), as in chains of pixels.
void ink_hairline(Place from, Place to, const SubGrid& grid, Bitmap& pixels);

}  // namespace unstep::render
