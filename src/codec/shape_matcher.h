#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "codec/placed_shape.h"
#include "unstep/bitmap.h"

namespace unstep::codec {

/// The shapes of a band in an order like that of reading, each with what it
/// refers to, if anything is like it. Their `reference` is the id that the
/// library of a scan over this list will have given.
std::vector<PlacedShape> match_shapes(const Bitmap& ink, std::int32_t first_row,
                                      std::int32_t rows);

/// How much shapes have to repeat: (share that refers)^2 x (steps around a
/// shape). On the drawings measured, coder 2 wins over contours above 35 and
/// loses below 31. From kShapesPayWell on it wins by more than a few per cent.
inline constexpr std::uint64_t kShapesPay = 32;
inline constexpr std::uint64_t kShapesPayWell = 48;

/// The same; none if they repeat less than `least`.
std::vector<PlacedShape> find_shapes(const Bitmap& ink, std::int32_t first_row,
                                     std::int32_t rows, std::uint64_t least);

}  // namespace unstep::codec
