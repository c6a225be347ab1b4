#pragma once

#include <cstddef>

#include "program/polyline.h"

namespace unstep {

/// True if the line between the written vertices `first` and `last` is within
/// the Frechet distance `tolerance` (program units) of the polyline between
/// the vertices. Exact but for rounding, which is below 1e-6 program units
/// for runs of less than 1 km. REQUIRES: first < last < size().
[[nodiscard]] bool line_fits(const Polyline& run, std::size_t first,
                             std::size_t last, double tolerance);

/// The last vertex, found by doubling and halving, that a line from `first`
/// can reach; at least first + 1. REQUIRES: first + 1 < size().
[[nodiscard]] std::size_t line_reach(const Polyline& run, std::size_t first,
                                     double tolerance);

}  // namespace unstep
