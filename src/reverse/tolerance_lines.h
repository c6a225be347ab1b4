#pragma once

#include <cstddef>
#include <vector>

#include "reverse/chain_walk.h"
#include "reverse/look_memory.h"
#include "reverse/near_directions.h"
#include "reverse/tolerance_cone.h"

namespace unstep::reverse {

/// The lines of one chain, as the vertices of a path with Frechet distance at
/// most the tolerance: the first vertex and every line's end. No line has
/// length 0; a chain without steps gives one vertex.
///
/// Of an open chain the first vertex is its point 0 and the last its point
/// size(). Of a closed one the first may be any point, index i < size(), and
/// the last is the same point, index i + size().
using LineVertices = std::vector<LineVertex>;

/// Closed chains of so few steps, most of them dust, keep every corner: their
/// ink stays as it is.
inline constexpr std::size_t kSpeckSteps = 8;

/// One pass, vertices on points of the chain: from each vertex the farthest
/// point to which the cone allows a line. Time O(steps).
/// `near` and `memory`, which only serves beside it: of the same tolerance, or
/// nullptr; the lines are the same.
LineVertices fit_lines(const ChainWalk& chain, PathTolerance tolerance,
                       const NearDirections* near = nullptr,
                       LookMemory* memory = nullptr);

/// The same for a part of a chain, from the last of `vertices`, a point of the
/// chain, to point `last`; no line stands for more than `longest` >= 1 steps.
/// Appends the lines' ends.
void fit_lines_between(const ChainWalk& chain, PathTolerance tolerance,
                       std::size_t last, std::size_t longest,
                       LineVertices& vertices);

}  // namespace unstep::reverse
