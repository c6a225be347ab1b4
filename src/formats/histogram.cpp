#include "formats/histogram.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace unstep {

int otsu_level(const Histogram& histogram) {
  double count = 0;
  double sum = 0;
  for (std::size_t i = 0; i < 256; ++i) {
    count += static_cast<double>(histogram[i]);
    sum += static_cast<double>(i) * static_cast<double>(histogram[i]);
  }
  double below = 0;
  double sum_below = 0;
  double best = -1;
  int level = 128;
  for (std::size_t i = 0; i < 255; ++i) {
    below += static_cast<double>(histogram[i]);
    sum_below += static_cast<double>(i) * static_cast<double>(histogram[i]);
    const double above = count - below;
    if (below == 0 || above == 0) continue;
    const double gap = sum_below / below - (sum - sum_below) / above;
    const double variance = below * above * gap * gap;
    if (variance > best) {
      best = variance;
      level = static_cast<int>(i) + 1;
    }
  }
  return level;
}

double share_below(const Histogram& histogram, int level) {
  const auto middle = histogram.begin() + level;
  const auto below =
      std::accumulate(histogram.begin(), middle, std::uint64_t{0});
  const auto above = std::accumulate(middle, histogram.end(), std::uint64_t{0});
  return below + above == 0
             ? 0
             : static_cast<double>(below) / static_cast<double>(below + above);
}

std::uint8_t mode_above(const Histogram& histogram, int level) {
  const auto most =
      std::max_element(histogram.begin() + level, histogram.end());
  return static_cast<std::uint8_t>(most - histogram.begin());
}

}  // namespace unstep
