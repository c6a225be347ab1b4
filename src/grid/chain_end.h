#pragma once

#include "unstep/grid.h"

namespace unstep {

/// The point where the last step of a chain ends. REQUIRES: within int32.
[[nodiscard]] inline Point chain_end(const Chain& chain, YAxis axis) {
  Point at = chain.origin;
  for (const Step step : chain.steps) {
    const Point move = step_delta(step, axis);
    at = {at.x + move.x, at.y + move.y};
  }
  return at;
}

}  // namespace unstep
