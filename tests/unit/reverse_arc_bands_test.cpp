#include <gtest/gtest.h>

#include "reverse/arcs.h"
#include "unit/reverse_tolerance_chains.h"

namespace unstep::reverse {
namespace {

using namespace testing;

/// Rings all over, and again a little aside: arcs that cross.
std::vector<Chain> contours() {
  std::vector<Chain> result;
  for (const Chain& ring : contours_of(disc(14, 9))) {
    for (std::int32_t i = 0; i < 24; ++i) {
      for (const std::int32_t aside : {0, 5}) {
        if (aside > 0 && i % 3 == 0) continue;
        Chain moved = ring;
        moved.origin.x += i % 4 * 40 + aside;
        moved.origin.y += i / 4 * 40 + aside;
        // No circle: those go as a whole.
        moved.steps.insert(moved.steps.begin(), 20, 0);
        moved.steps.insert(moved.steps.begin() + 20, 20, 4);
        result.push_back(std::move(moved));
      }
    }
  }
  return result;
}

std::vector<ArcPath> arcs_of(const std::vector<Chain>& chains) {
  const PathTolerance tolerance;
  const ArcFitter fitter(tolerance, 1);
  std::vector<ArcPath> paths;
  for (const Chain& chain : chains) {
    const ChainWalk walk(chain, YAxis::down, 1);
    paths.push_back(fit_arcs(walk, fitter, fit_lines(walk, tolerance)));
  }
  return paths;
}

TEST(ArcCrossings, NoneIsLeftWhateverTheBands) {
  const std::vector<Chain> chains = contours();
  const std::vector<bool> closed(chains.size(), true);
  std::vector<ArcPath> whole = arcs_of(chains);
  const std::uint64_t changed = remove_crossing_arcs(whole, closed, 1);
  EXPECT_GT(changed, 0U) << "a drawing that tries nothing";
  for (const std::int64_t parts : {1, 20, 150}) {
    std::vector<ArcPath> paths = arcs_of(chains);
    EXPECT_GT(remove_crossing_arcs(paths, closed, 1, parts), 0U);
    EXPECT_EQ(remove_crossing_arcs(paths, closed, 1), 0U) << parts;
    std::size_t left = 0;
    for (const ArcPath& path : paths) left += path.arcs.size();
    EXPECT_GT(left, 0U) << "the rings that stand alone keep theirs";
  }
}

}  // namespace
}  // namespace unstep::reverse
