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

/// The same; none if they are cheaper as contours.
std::vector<PlacedShape> find_shapes(const Bitmap& ink, std::int32_t first_row,
                                     std::int32_t rows);

}  // namespace unstep::codec
