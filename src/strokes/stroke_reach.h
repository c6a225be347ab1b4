#pragma once

#include <vector>

#include "strokes/stroke_piece.h"
#include "unstep/bitmap.h"

namespace unstep::strokes {

/// Ink is drawn well that is at most so far from what is drawn, and what is
/// drawn from ink, in squared pixels.
inline constexpr std::int64_t kReach = 4;

/// Lays paths again, nearer to their chains, where what they draw and the ink
/// are more than two pixels apart; narrows pens that draw beyond the ink, and
/// dots what is still missing.
Status keep_near(const Bitmap& ink, const Rational& tolerance,
                 std::int32_t scale, std::vector<Piece>& pieces);

}  // namespace unstep::strokes
