#pragma once

#include <array>
#include <cstdint>

namespace unstep {

/// How many pixels have each luminance.
using Histogram = std::array<std::uint64_t, 256>;

/// Otsu's method (N. Otsu, A threshold selection method from gray-level
/// histograms, 1979): the split with the greatest variance between classes.
/// Returns the first level that is paper, as cv::threshold's result + 1.
[[nodiscard]] int otsu_level(const Histogram& histogram);

/// The share of pixels below a level, 0..1.
[[nodiscard]] double share_below(const Histogram& histogram, int level);

/// The most frequent luminance of `level` and above.
[[nodiscard]] std::uint8_t mode_above(const Histogram& histogram, int level);

}  // namespace unstep
