#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "unstep/bitmap.h"
#include "unstep/grid.h"
#include "unstep/result.h"

/// A skeleton as a graph.
namespace unstep::trace {

/// A pixel of a skeleton and the square of its distance to the nearest paper
/// pixel, centre to centre (at least 1).
struct Spot {
  Point at;
  std::int64_t square = 1;
};

/// Half the width of the ink around a spot: the distance to paper is to the
/// middle of a paper pixel, half a unit beyond the edge.
[[nodiscard]] double radius_of(const Spot& spot);

/// Where lines meet: pixels with three neighbours or more that touch.
struct Junction {
  std::vector<Spot> spots;
  std::vector<std::size_t> branches;  ///< indices; twice if both ends are here
  Spot middle;                        ///< the one with the most ink around it
};

/// A line between junctions or ends: 8-connected spots, none of a junction.
struct Branch {
  static constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<Spot> spots;   ///< not empty
  std::size_t from = kNone;  ///< the junction before the first spot
  std::size_t to = kNone;    ///< the one after the last
  bool closed = false;       ///< a ring without a junction
};

/// Of graph_of(): every pixel of the skeleton is a spot of exactly one junction
/// or branch.
struct SkeletonGraph {
  std::vector<Junction> junctions;
  std::vector<Branch> branches;
};

/// `skeleton` is what thin() leaves of `ink`. Junctions and branches are in
/// raster order of their first pixels. limit_exceeded for 2^32 pixels or more.
Result<SkeletonGraph> graph_of(const Bitmap& ink, const Bitmap& skeleton);

}  // namespace unstep::trace
