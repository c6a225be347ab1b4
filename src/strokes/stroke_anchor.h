#pragma once

#include <vector>

#include "strokes/stroke_piece.h"

namespace unstep::strokes {

/// Lets paths begin exactly on a vertex or a line of an earlier path where they
/// begin near one, within the tolerance of their chains: coder 25 tells such a
/// beginning in few bits.
void anchor_paths(std::vector<Piece>& pieces, const Rational& tolerance,
                  std::int32_t scale);

}  // namespace unstep::strokes
