#pragma once

#include "trace/skeleton_graph.h"

namespace unstep::trace {

/// A line that ends within this many half widths of where it leaves another is
/// what noise or a corner of the ink makes of it: the corner of a square end is
/// 1.42 away from the middle.
inline constexpr double kSpurReach = 1.54;

/// ... and within this many pixels besides, fewer on lines below 3 pixels.
inline constexpr double kSpurSlack = 2.0;

/// Takes away branches that only lead from a junction to its ink's edge, the
/// shortest for the width first; junctions that are left with two branches join
/// them. Junctions with fewer become a branch of their pixels.
void prune_spurs(SkeletonGraph& graph);

}  // namespace unstep::trace
