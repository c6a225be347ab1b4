#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "unstep/grid.h"

namespace unstep::steps {

/// How much farther the end of an arc from (0, 0) is from the centre than the
/// start, squared.
[[nodiscard]] inline std::int64_t off_circle(Point centre, Point end) {
  const std::int64_t x = std::int64_t{end.x} - centre.x;
  const std::int64_t y = std::int64_t{end.y} - centre.y;
  const std::int64_t cx = centre.x;
  const std::int64_t cy = centre.y;
  return x * x + y * y - cx * cx - cy * cy;
}

/// By how many steps the radius at the end is larger. REQUIRES: centre is not
/// (0, 0).
[[nodiscard]] inline double radius_change(Point centre, Point end) {
  return static_cast<double>(off_circle(centre, end)) /
         (2 * std::hypot(centre.x, centre.y));
}

/// Whether the strictest of the controls (ArcRules) takes the arc, a step
/// being `step_mm` long: its radii at start and end agree.
[[nodiscard]] inline bool control_takes(Point centre, Point end,
                                        double step_mm) {
  const double radius = std::hypot(centre.x, centre.y);
  return std::abs(radius_change(centre, end)) * step_mm <=
         std::max(0.0009, std::min(0.1, 7e-4 * radius * step_mm));
}

}  // namespace unstep::steps
