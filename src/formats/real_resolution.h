#pragma once

#include <string_view>

#include "unstep/codec.h"

namespace unstep {

/// The rational of the least denominator from `low` to `high`; 0/1 if none fits
/// uint32. REQUIRES: 0 < low <= high.
[[nodiscard]] Rational simplest_rational(double low, double high);

/// grid units / length, for a length that was written with `decimals` places
/// after the point: the simplest number that explains it, if its digits are
/// many enough to have been rounded. 0/1 if it is none.
[[nodiscard]] Rational density(double grid_units, double length, int decimals);

}  // namespace unstep
