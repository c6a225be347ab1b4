#pragma once

#include <cstdint>

#include "unstep/grid.h"
#include "unstep/result.h"

namespace unstep::reverse {

/// Success if the chain's steps fit its connectivity, every point times
/// `scale` is within the coordinate range and a closed chain ends at its
/// origin. invalid_argument naming the step if not.
Status check_chain(const Chain& chain, YAxis axis, std::int32_t scale);

}  // namespace unstep::reverse
