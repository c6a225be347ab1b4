#include <gtest/gtest.h>

#include "reverse/tolerance_optimum.h"
#include "unit/frechet_oracle.h"
#include "unit/reverse_tolerance_chains.h"

namespace unstep::reverse {
namespace {

using namespace testing;

/// The fewest lines with vertices on the chain, each line tried by the
/// free-space diagram.
std::size_t fewest(const Polyline& points, long double e) {
  std::vector<std::size_t> lines(points.size(), points.size());
  lines[0] = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = i + 1; k < points.size(); ++k) {
      if (points[i].x == points[k].x && points[i].y == points[k].y) continue;
      const Polyline part(points.begin() + static_cast<std::ptrdiff_t>(i),
                          points.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      if (!frechet_within(part, {part.front(), part.back()}, e)) continue;
      lines[k] = std::min(lines[k], lines[i] + 1);
    }
  }
  return lines.back();
}

TEST(ReverseTolerance, LinesAreNearTheFewestThereCanBe) {
  std::mt19937 random(8);
  std::size_t best = 0;
  std::size_t searched = 0;
  std::size_t one_pass = 0;
  for (int run = 0; run < 60; ++run) {
    const Chain chain = random_chain(random, 60, 5);
    const ChainWalk walk(chain, YAxis::up, 1);
    const std::size_t least = fewest(polyline_of(chain, YAxis::up), 1);
    const std::size_t found = fit_fewest_lines(walk, {4096}).size() - 1;
    EXPECT_GE(found, least);
    best += least;
    searched += found;
    one_pass += fit_lines(walk, {4096}).size() - 1;
  }
  EXPECT_LE(searched * 100, best * 103) << searched << " / " << best;
  EXPECT_LE(one_pass * 100, best * 108) << one_pass << " / " << best;
}

}  // namespace
}  // namespace unstep::reverse
