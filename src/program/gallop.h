#pragma once

#include <algorithm>
#include <cstddef>

namespace unstep {

/// The last index from `good` to `end` that `fits`, if fitting were monotone:
/// doubles its way up and halves the last step. `good` is known to fit.
template <class Fits>
std::size_t gallop(std::size_t good, std::size_t end, const Fits& fits) {
  std::size_t step = 1;
  std::size_t bad = end + 1;
  while (good < end) {
    const std::size_t next = std::min(good + step, end);
    if (!fits(next)) {
      bad = next;
      break;
    }
    good = next;
    step *= 2;
  }
  while (good + 1 < bad) {
    const std::size_t middle = good + (bad - good) / 2;
    if (fits(middle)) {
      good = middle;
    } else {
      bad = middle;
    }
  }
  return good;
}

}  // namespace unstep
