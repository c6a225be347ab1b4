#pragma once

#include <cstdint>

#include "render/sub_grid.h"
#include "unstep/bitmap.h"

namespace unstep::render {

/// Inks the pixels whose centres are at most `radius` sub-units from the line.
/// Exact. Time: rows that it may reach, times the logarithm of the columns.
/// REQUIRES: 0 <= radius < 2^40.
void ink_stroke(Place from, Place to, std::int64_t radius, const SubGrid& grid,
                Bitmap& pixels);

}  // namespace unstep::render
