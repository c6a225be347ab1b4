#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "trace/skeleton_graph.h"
#include "trace/vector2.h"
#include "unstep/bitmap.h"

namespace unstep::trace {

/// The way of a stroke: 8-connected spots. Those of a straight piece laid
/// through a junction have square 0: what is around them is not the stroke's.
struct Route {
  std::vector<Spot> spots;  ///< not empty
  bool closed = false;
  bool free_from = true;  ///< begins where a line ends, not at another one
  bool free_to = true;
};

/// Spots of the digital line after `from`, up to `to`; square 0.
void append_line(std::vector<Spot>& spots, Point from, Point to);

/// The direction of the spots, from the first to the last; (0, 0) if there is
/// but one.
[[nodiscard]] Vector2 direction_of(std::span<const Spot> spots);

/// Joins the branches of a pruned skeleton to long strokes: at each junction
/// those that continue straightest, so that a crossing is two strokes and a
/// T keeps its bar; what is left over ends on the others. Junctions whose ink
/// overlaps count as one, since thinning makes two of a slanting crossing.
/// Near a junction the skeleton bends; strokes go straight there.
[[nodiscard]] std::vector<Route> routes_of(const Bitmap& ink,
                                           const SkeletonGraph& graph);

}  // namespace unstep::trace
