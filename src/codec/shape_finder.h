#pragma once

#include <cstdint>
#include <vector>

#include "codec/shape_glyph.h"
#include "unstep/bitmap.h"

namespace unstep::codec {

/// An 8-connected set of ink pixels: its box, how many, and one of them.
struct Component {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t right = 0;   ///< one past the box
  std::int32_t bottom = 0;  ///< one past the box
  std::int64_t pixels = 0;
  std::int32_t seed = 0;  ///< a column of the top row that is ink

  [[nodiscard]] std::int32_t width() const { return right - x; }
  [[nodiscard]] std::int32_t height() const { return bottom - y; }
};

/// The components of rows [first_row, first_row + rows), y from first_row, in
/// the order of their top rows. Empty if there are more than `most`, so that
/// memory is bounded on noise.
std::vector<Component> find_components(const Bitmap& ink,
                                       std::int32_t first_row,
                                       std::int32_t rows, std::size_t most);

/// The pixels of a component alone. REQUIRES: no side above kMaxShapeSide.
Glyph cut_out(const Bitmap& ink, std::int32_t first_row,
              const Component& component);

}  // namespace unstep::codec
