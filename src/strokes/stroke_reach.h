#pragma once

#include <vector>

#include "strokes/stroke_piece.h"
#include "unstep/bitmap.h"

namespace unstep::strokes {

/// How far ink may be from what is drawn, and what is drawn from ink, in
/// squared pixels: two pixels, or the tolerance and one.
[[nodiscard]] std::int64_t reach_of(const Rational& tolerance);

/// Lays paths again, nearer to their chains and with narrower pens, that draw
/// farther beyond the ink than that, and dots what is missing.
Status keep_near(const Bitmap& ink, const Rational& tolerance,
                 std::int32_t scale, std::vector<Piece>& pieces);

}  // namespace unstep::strokes
