#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reverse/tolerance_lines.h"

namespace unstep::reverse {

/// Where vertices are: each on its point of the chain, or within the tolerance.
enum class VerticesAt : std::uint8_t { chain, anywhere };

/// Makes lines finer where two of them cross or lie on each other although
/// their chains do neither there: the longer of the two is cut into lines of at
/// most half its steps, with vertices on the chain, as often as needed. Ends
/// with the chain itself at the latest, so that afterwards such lines meet
/// only where chains touch. `paths[i]` belongs to `chains[i]`; the bound
/// keeps. Returns how many paths were changed.
std::uint64_t refine_crossings(std::span<const ChainWalk> chains,
                               PathTolerance tolerance, VerticesAt at,
                               std::span<LineVertices> paths);

}  // namespace unstep::reverse
