#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "unstep/grid.h"
#include "unstep/step_stream.h"

namespace unstep::steps {

/// An arc and how many steps it draws.
struct ExactArc {
  Arc arc;
  std::size_t steps = 0;
};

/// The longest arc found from the first step on that Method::circular draws
/// with exactly these steps, of more than `least`; nothing if there is none.
/// `points[i]` is where the pen is before step i, one more than steps. Of
/// ends that do as well, one on the circle is taken; controls accept the radius
/// at the end if a step is `step_mm` long.
[[nodiscard]] std::optional<ExactArc> longest_arc(std::span<const Step> steps,
                                                  std::span<const Point> points,
                                                  std::size_t least,
                                                  bool combined,
                                                  double step_mm);

}  // namespace unstep::steps
