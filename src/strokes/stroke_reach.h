#pragma once

#include <vector>

#include "strokes/stroke_piece.h"
#include "unstep/bitmap.h"

namespace unstep::strokes {

/// How far ink may be from what is drawn, and what is drawn from ink, in
/// squared pixels: two pixels, or the tolerance and one.
[[nodiscard]] std::int64_t reach_of(const Rational& tolerance);

/// Lays paths again, nearer to their chains, where what they draw and the ink
/// are farther apart than that; narrows pens that draw beyond the ink, and
/// dots what is still missing. With `dots_alone` paths that miss ink stay as
/// they are: a dot takes fewer bytes than a path that is nearer.
Status keep_near(const Bitmap& ink, const Rational& tolerance,
                 std::int32_t scale, bool dots_alone,
                 std::vector<Piece>& pieces);

}  // namespace unstep::strokes
