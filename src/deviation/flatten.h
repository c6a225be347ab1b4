#pragma once

#include <cstdint>
#include <vector>

#include "unstep/grid.h"

/// Chains and paths as polylines of floating-point places, in grid units
/// relative to the chain's first point (so that small drawings far out lose
/// nothing).
namespace unstep::deviation {

struct Place {
  long double x = 0;
  long double y = 0;
};

[[nodiscard]] long double distance(Place a, Place b);

/// A circle's angle and turn, positive counter-clockwise by the numbers.
struct ArcCurve {
  Place centre;  ///< relative to the start
  long double radius = 0;
  long double first = 0;
  long double turn = 0;
};
/// REQUIRES: the arc has a radius.
[[nodiscard]] ArcCurve curve_of(const Arc& arc);

/// The points of the chain; equal steps are not joined.
[[nodiscard]] std::vector<Place> polyline_of(const Chain& chain, YAxis axis);

/// The path, arcs as chords that are nowhere farther from their arc than
/// `sagitta`; the first place is `origin`.
[[nodiscard]] std::vector<Place> polyline_of(const Path& path,
                                             std::int32_t scale, Place origin,
                                             long double sagitta);

}  // namespace unstep::deviation
