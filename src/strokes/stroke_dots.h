#pragma once

#include <cstdint>
#include <vector>

#include "strokes/stroke_piece.h"
#include "unstep/bitmap.h"

namespace unstep::strokes {

/// Takes away the dots that stand beside lines: they cover what was missing
/// beside these, and add_dots() finds what is missing beside their paths.
void drop_dots(std::vector<Piece>& pieces);

/// Dots the ink whose squared distance from what is drawn is above `reach`.
/// Each dot follows the piece beside which it stands and the others of that
/// piece's group, so that coder 25 finds it near what it knows.
Status add_dots(const Bitmap& ink, const Bitmap& drawn, std::int64_t reach,
                std::int32_t scale, std::vector<Piece>& pieces);

}  // namespace unstep::strokes
