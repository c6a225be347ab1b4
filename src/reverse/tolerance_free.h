#pragma once

#include <cstddef>

#include "reverse/tolerance_lines.h"

namespace unstep::reverse {

/// Lines whose vertices are free: any point of the path's grid within the
/// tolerance of the chain. On a fine grid that needs little more than the
/// digital straight segments of the chain, where vertices on the chain need
/// several times as many.
///
/// After Guibas, Hershberger, Mitchell and Snoeyink (1993), who go from region
/// to region that k lines reach: here, for each place of a vertex relative to
/// the chain (a point of the disc; at most about 4 * width^2 of them), the
/// farthest point of the chain beside which k lines can end at that place.
/// Ends of open chains are fixed; a ring is laid from a vertex of the one-pass
/// fit, and once more from a point of the chain half-way round; the better
/// counts.
///
/// Time O(places^2 * steps), memory O(places + lines).
LineVertices fit_free_lines(const ChainWalk& chain, PathTolerance tolerance,
                            int width);

}  // namespace unstep::reverse
