#pragma once

#include <string_view>

#include "unstep/bitmap.h"
#include "unstep/result.h"

/// The eight orientations of TIFF tag 274 (TIFF 6.0, page 36) and of EXIF.
namespace unstep {

/// "top-right" and so on. REQUIRES: 1 <= orientation <= 8.
[[nodiscard]] std::string_view orientation_name(int orientation);

/// True if rows and columns are exchanged (5..8).
[[nodiscard]] constexpr bool is_transposed(int orientation) {
  return orientation >= 5;
}

/// Turns the stored pixels so that row 0 is the visual top and column 0 the
/// visual left. REQUIRES: 1 <= orientation <= 8. In place for 1..4; 5..8 hold
/// a second raster for a while. limit_exceeded if there is no memory for it.
Status apply_orientation(int orientation, Bitmap& ink);

}  // namespace unstep
