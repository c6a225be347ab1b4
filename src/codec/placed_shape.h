#pragma once

#include <cstddef>
#include <cstdint>

#include "codec/shape_glyph.h"
#include "unstep/bitmap.h"

namespace unstep::codec {

/// One shape of coder 2 and how it is told from those before.
struct PlacedShape {
  std::int32_t x = 0;  ///< of the left column, in the band
  std::int32_t y = 0;  ///< of the top row
  bool new_line = false;
  bool refers = false;
  std::uint32_t reference = 0;  ///< an id of the library
  std::int32_t dx = 0;  ///< pixel (i, j) lies over (i + dx, j + dy) of the
  std::int32_t dy = 0;  ///< reference, both from the middle
  Glyph glyph;

  [[nodiscard]] std::int32_t width() const { return glyph.width; }
  [[nodiscard]] std::int32_t height() const { return glyph.height; }
};

/// What telling a shape costs, in pixels: the work of decoding it.
[[nodiscard]] constexpr std::uint64_t shape_cost(std::int32_t width,
                                                 std::int32_t height) {
  return 64 +
         static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}
/// What all shapes of a band together may cost. Near-certain decisions take
/// next to no bytes, so a small payload could ask for any work; drawings need
/// a quarter of this. No overflow: sides are below 2^30.
[[nodiscard]] constexpr std::uint64_t shape_room(std::int32_t width,
                                                 std::int32_t rows) {
  return 4 * static_cast<std::uint64_t>(width) *
             static_cast<std::uint64_t>(rows) +
         65536;
}

/// Calls `apply(word, bits)` for the words of the band's bitmap that a shape
/// lies on. REQUIRES: it lies within.
template <class Apply>
void merge_shape(Bitmap& ink, std::int32_t first_row, const PlacedShape& shape,
                 Apply apply) {
  const auto first = static_cast<std::size_t>(shape.x) / 64;
  const auto shift = static_cast<unsigned>(shape.x) % 64;
  for (std::int32_t y = 0; y < shape.glyph.height; ++y) {
    const auto to = ink.row(first_row + shape.y + y);
    for (std::size_t i = 0; i < shape.glyph.stride(); ++i) {
      const std::uint64_t word = shape.glyph.row(y)[i];
      apply(to[first + i], word >> shift);
      const std::uint64_t next = shift == 0 ? 0 : word << (64 - shift);
      if (next != 0) apply(to[first + i + 1], next);
    }
  }
}

}  // namespace unstep::codec
