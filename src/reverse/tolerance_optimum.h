#pragma once

#include "reverse/tolerance_lines.h"

namespace unstep::reverse {

/// As few lines as there can be with vertices on points of the chain, among
/// them those that cost the fewest bits: a shortest path over all lines that
/// the cone allows (Imai and Iri 1986).
///
/// Window: no line of the search spans more than kSearchWindow steps. A line
/// of the one-pass fit that is longer than half of it is kept, and the search
/// fills the parts between; that costs at most one line more per line kept. A
/// ring of up to kSearchWindow steps tries every start that can be the best
/// one; a longer one starts at a vertex of the one-pass fit and then, again,
/// half-way round.
///
/// Time O(steps * longest line), at most O(steps * kSearchWindow).
inline constexpr std::size_t kSearchWindow = 2048;

LineVertices fit_fewest_lines(const ChainWalk& chain, PathTolerance tolerance);

}  // namespace unstep::reverse
