#pragma once

#include <vector>

#include "strokes/stroke_piece.h"

namespace unstep::strokes {

/// Gives small groups the paths of an earlier group, moved, where each path is
/// within the tolerance of its own chain, and the pens and shifts of that
/// group; so that what is drawn alike is stored once.
void repeat_groups(std::vector<Piece>& pieces, const Rational& tolerance,
                   std::int32_t scale);

}  // namespace unstep::strokes
