#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "unstep/grid.h"
#include "unstep/interpolate.h"
#include "unstep/result.h"

/// Bulk drawing in letters of one's own: what a step is called costs nothing
/// where it is drawn, but a pass over all steps afterwards.
namespace unstep::interpolation {

/// What stands for each Freeman code.
using Letters = std::array<std::uint8_t, 8>;
inline constexpr Letters kFreemanLetters{0, 1, 2, 3, 4, 5, 6, 7};

/// True for the methods that draw_lines() draws.
[[nodiscard]] constexpr bool draws_in_bulk(Method method) {
  return method == Method::device || method == Method::evaluation ||
         method == Method::evaluation8;
}

/// unstep::interpolate() in these letters. REQUIRES: draws_in_bulk(method).
Result<std::size_t> draw_lines(Method method, std::span<const Segment> segments,
                               std::span<std::uint8_t> out,
                               const Letters& letters);

}  // namespace unstep::interpolation
