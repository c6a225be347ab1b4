#pragma once

#include <cstdint>

#include "unstep/grid.h"
#include "unstep/result.h"

/// How far a path is from the chain that it stands for. Written apart from
/// reverse interpolation, so that one proves the other.
///
///     Result<Deviation> found = measure_deviation(traced, decoded);
///     if (found && found->distance > 1.0) complain(found->where);
namespace unstep {

/// The largest Frechet distance between a chain and its path, and where.
struct Deviation {
  double distance = 0;   ///< grid units, rounded up: the true one is not larger
  std::size_t path = 0;  ///< index of the chain and of its path
  std::size_t step = 0;  ///< the chain has made this many steps there
  double x = 0;          ///< the place, grid units
  double y = 0;
};

/// Measures every path of `paths` against the chain of the same index in
/// `chains`: the Euclidean Frechet distance between the polyline through the
/// chain's points and the path's lines and arcs, before rasterising. A closed
/// path may start at any point of its closed chain. Slow (quadratic in the
/// worst case) and thorough.
/// invalid_argument if their numbers differ or one is closed and its
/// counterpart is not.
Result<Deviation> measure_deviation(const Drawing& chains,
                                    const Drawing& paths);

/// The fast, exact form: success if the distance is at most `tolerance`,
/// decided in integers. `corrupt`, naming path and place, if it is not.
/// invalid_argument as above.
Status check_deviation(const Drawing& chains, const Drawing& paths,
                       const Rational& tolerance);

/// The guarantee of device mode (SU 1089551): draws the segments of `paths`
/// with Method::device and compares point by point. `distance` is the largest
/// difference on one axis at the same step index; at most 1 for what
/// DeviceReverse makes. invalid_argument if numbers, ends or lengths differ, or
/// a path has arcs.
Result<Deviation> measure_device_deviation(const Drawing& chains,
                                           const Drawing& paths);

}  // namespace unstep
