#pragma once

#include <cstddef>
#include <vector>

#include "deviation/curves.h"
#include "unstep/grid.h"

/// Which places of the chain can be reached while the path is walked, never
/// leaving the bound and never going back: the free space of Alt and Godau
/// (Computing the Frechet distance between two polygonal curves, 1995), row by
/// row, a row being an element of the path, over the part that is reached.
///
/// Ends of intervals are p +- sqrt(s) with integers p and s; they are never
/// computed, only compared. Lines are decided exactly. An arc is passed along
/// the radii: success is certain, failure is not (see arc_row.cpp).
namespace unstep::deviation {

/// The lower end of an interval, p - sqrt(s), in a unit of the edge or line.
struct LowEnd {
  Int128 p = 0;
  UInt128 s = 0;
};

[[nodiscard]] inline bool at_most(const LowEnd& a, const LowEnd& b) {
  return low_end_at_most(a.p, a.s, b.p, b.s);
}

/// low <= q + sqrt(t), the upper end of another interval on the same line.
[[nodiscard]] inline bool meets(const LowEnd& low, Int128 q, UInt128 t) {
  return low.p <= q ||
         at_most_sum_of_roots(static_cast<UInt128>(low.p - q), low.s, t);
}

/// What a disc cuts from an edge of the chain: p +- sqrt(s), clipped to the
/// edge, in 1 / (denominator |step|) of path units.
struct EdgeCut {
  bool any = false;
  Int128 p = 0;
  UInt128 s = 0;
};

/// The edge from `from` by the unit step `step` times bound.unit. Range: what
/// is computed has |centre - from| <= reach + 2 unit < 2^31 on each axis, so
/// |p| < 2^63 and s <= 2 numerator^2 <= 2^61.
[[nodiscard]] EdgeCut cut_edge(const Bound& bound, Vector64 from, Vector64 step,
                               Vector64 centre);

/// What is reached of an edge at a vertex of the path: from `low` to the end
/// of what the disc about the vertex cuts from it.
struct Entry {
  std::size_t edge = 0;
  LowEnd low;
};

/// What is reached at the current vertex of the path.
struct Front {
  Bound bound;
  ChainWalk chain;
  Vector64 first;              ///< the chain's first point
  std::vector<Entry> entries;  ///< by edge
  std::vector<Entry> next;     ///< those of the next vertex, while a row runs
  bool corner = false;         ///< the chain's first point is reached
  bool last = false;           ///< its last point is, within the last row
  std::size_t farthest = 0;    ///< the most steps that were reached

  Front(const Bound& tolerance, const ChainWalk& walk)
      : bound(tolerance), chain(walk), first(walk.at()) {}

  /// The path starts at `vertex` and the chain at its first point, or at
  /// `place` on its first edge. False if that is too far apart.
  bool start(Vector64 vertex);
  bool start_on_edge(Vector64 vertex, Vector64 place);

  /// Something is reached.
  [[nodiscard]] bool alive() const { return corner || !entries.empty(); }

  /// `place` on the last edge is reached at `vertex`.
  [[nodiscard]] bool ends_on_edge(Vector64 place);
};

/// Walks one element of the path from `from`; both leave the front at its end.
/// REQUIRES: front.alive().
void walk_line(Front& front, Vector64 from, Segment segment);
/// REQUIRES: arc_is_decidable(front.bound, arc).
void walk_arc(Front& front, Vector64 from, const Arc& arc);

/// The numbers of the arc and of the bound fit walk_arc, and its radius is
/// more than the bound by two grid units at least.
[[nodiscard]] bool arc_is_decidable(const Bound& bound, const Arc& arc);

}  // namespace unstep::deviation
