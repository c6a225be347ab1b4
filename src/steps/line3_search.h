#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "unstep/step_stream.h"

namespace unstep::steps {

using GridDelta = std::array<std::int32_t, kMaxStepAxes>;

/// No line found is longer than so many steps.
inline constexpr std::size_t kReach = std::size_t{1} << 22;

/// Steps of a long line of three axes that begins at step `at` and makes just
/// these, and how far it leads. At least 1: a single step always is a line.
std::size_t longest_line3(const std::vector<StepWord>& words, std::size_t at,
                          GridDelta& best);

}  // namespace unstep::steps
