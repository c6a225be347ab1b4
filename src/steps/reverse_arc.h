#pragma once

#include <cstddef>
#include <functional>
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

/// An arc that begins before the element before it must end.
struct LaterArc {
  std::size_t begin = 0;
  ExactArc arc;
};

/// What is longest from one vertex on runs over into an arc that leaves it in
/// its direction, which then is found no more. Looks for an arc that goes on
/// from `last`, where the longest element ends, but begins between `first` and
/// there at a place where that element may end too. Steps and points as above.
[[nodiscard]] std::optional<LaterArc> later_arc(
    std::span<const Step> steps, std::span<const Point> points,
    std::size_t first, std::size_t last, bool combined, double step_mm,
    const std::function<bool(std::size_t)>& may_begin);

}  // namespace unstep::steps
