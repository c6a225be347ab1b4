#pragma once

#include <cstddef>

#include "deviation/flatten.h"
#include "unstep/grid.h"

/// The Frechet distance by floating-point free space: all cases, no range, an
/// upper bound.
namespace unstep::deviation {

/// True only if the distance is at most `limit`, grid units.
[[nodiscard]] bool thorough_within(const Chain& chain, const Path& path,
                                   YAxis axis, std::int32_t scale,
                                   double limit);

struct Measured {
  double distance = 0;   ///< not less than the true one
  std::size_t step = 0;  ///< of the chain
  Place place;           ///< relative to the chain's first point
};
/// A distance of at most `known` need not be found more exactly.
[[nodiscard]] Measured thorough_measure(const Chain& chain, const Path& path,
                                        YAxis axis, std::int32_t scale,
                                        double known);

}  // namespace unstep::deviation
