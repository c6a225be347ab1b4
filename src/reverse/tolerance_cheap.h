#pragma once

#include "reverse/cheap_search.h"
#include "reverse/line_price.h"
#include "reverse/tolerance_lines.h"

namespace unstep::reverse {

/// The lines of one chain that cost the fewest bits, about: a shortest path
/// over free vertices, points of the path's grid within the tolerance of the
/// chain, where an edge costs what its line costs after the line before it
/// (vertex-based shape coding, A. Katsaggelos et al. 1998). Each vertex keeps
/// the cheapest way to it alone.
///
/// A ring starts at the topmost vertex, then leftmost, on the chain, which is
/// where a coder of paths begins it; its last line is free. Long lines of the
/// one-pass fit are kept as they are, and the search does the parts between in
/// windows of kCheapWindow candidates; so time is O(steps * kCheapLine) at
/// most, and memory small.
///
/// `search` is for the same tolerance. At most `starts` points of the topmost
/// row are tried as starts of a ring.
LineVertices fit_cheap_lines(CheapSearch& search, const ChainWalk& chain,
                             PathTolerance tolerance, const LinePrice& price,
                             std::size_t starts);

/// Lines of the one-pass fit that are longer are not searched.
inline constexpr std::size_t kCheapLine = 256;
inline constexpr std::size_t kCheapWindow = 2048;

}  // namespace unstep::reverse
