#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "reverse/refine.h"
#include "reverse/swept_points.h"
#include "unit/reverse_tolerance_chains.h"

namespace unstep::reverse {
namespace {

using namespace testing;

constexpr PathTolerance kOne;

/// The lines of some chains before any is cut.
struct Fitted {
  explicit Fitted(std::vector<Chain> from) : chains(std::move(from)) {
    for (const Chain& chain : chains) {
      walks.emplace_back(chain, YAxis::down, 1);
      closed.push_back(chain.closed);
      lines.push_back(fit_lines(walks.back(), kOne));
    }
  }
  std::vector<Chain> chains;  ///< the walks read them
  std::vector<ChainWalk> walks;
  std::vector<bool> closed;
  std::vector<LineVertices> lines;
};

using Pair =
    std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

/// Each once, in one order.
std::vector<Pair> in_order(const std::vector<CrossingPair>& pairs) {
  std::vector<Pair> result;
  for (const CrossingPair& pair : pairs) {
    const std::tuple first{pair.first.path, pair.first.line};
    const std::tuple second{pair.second.path, pair.second.line};
    result.push_back(
        std::tuple_cat(std::min(first, second), std::max(first, second)));
  }
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<Pair> swept(const Fitted& fitted) {
  return in_order(
      SweptPoints(fitted.walks, fitted.lines, fitted.closed).find_all());
}

std::vector<Pair> through_grid(const Fitted& fitted) {
  const std::vector<Box> all{kEverywhere};
  return in_order(find_crossings(fitted.lines, fitted.closed, all, 16));
}

/// Refined through the points or through the grid, chains become the same
/// lines.
void expect_same_lines(const std::vector<Chain>& chains) {
  Fitted points(chains);
  Fitted grid(chains);
  const std::uint64_t refined =
      refine_crossings(grid.walks, kOne, VerticesAt::anywhere, grid.lines);
  EXPECT_EQ(
      refine_crossings(points.walks, kOne, VerticesAt::chain, points.lines),
      refined);
  EXPECT_EQ(points.lines, grid.lines);
}

/// Strokes a pixel wide in any direction: both sides have lines close by, and
/// diagonal ones touch in every corner.
Bitmap thin_strokes(std::mt19937& random, std::int32_t size, int strokes) {
  Bitmap ink = *Bitmap::create(size, size);
  const auto any = [&] {
    return static_cast<std::int32_t>(random() % static_cast<unsigned>(size));
  };
  for (int i = 0; i < strokes; ++i) {
    const Point a{any(), any()};
    const Point b{any(), any()};
    const int steps = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) + 1;
    for (int k = 0; k <= steps; ++k)
      ink.set(a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps,
              true);
  }
  return ink;
}

TEST(SweptPoints, ShowTheCrossingsOfContours) {
  std::mt19937 random(31);
  std::size_t count = 0;
  for (int run = 0; run < 60; ++run) {
    for (const Bitmap& ink :
         {thin_strokes(random, 90, 12), blots(random, 60, 30),
          blots(random, 60, 160), disc(20 + run, 19 + run)}) {
      const Fitted fitted(contours_of(ink));
      const std::vector<Pair> expected = through_grid(fitted);
      EXPECT_EQ(swept(fitted), expected) << run;
      count += expected.size();
    }
  }
  EXPECT_GT(count, 100U);
}

TEST(SweptPoints, LeadToTheSameLinesAsTheGrid) {
  std::mt19937 random(32);
  for (int run = 0; run < 40; ++run) {
    expect_same_lines(contours_of(thin_strokes(random, 120, 16)));
    expect_same_lines(contours_of(blots(random, 64, 100)));
    // Chains that cross, retrace and touch one another, of all directions.
    std::vector<Chain> chains;
    for (int i = 0; i < 12; ++i) {
      chains.push_back(random_chain(random, 1 + random() % 120, 3));
      if (i % 3 == 0) chains.push_back(retraced(chains.back()));
      if (i % 4 == 0) chains.push_back(chains.back());
      chains.back().origin = {static_cast<std::int32_t>(random() % 20), 3};
    }
    expect_same_lines(chains);
  }
}

TEST(SweptPoints, OfChainsFarApartAreKeptApart) {
  std::mt19937 random(33);
  const std::vector<Chain> contours =
      contours_of(thin_strokes(random, 100, 14));
  std::vector<Chain> chains;
  for (const Point corner : {Point{-kMaxCoord, -kMaxCoord},
                             {kMaxCoord - 100, -kMaxCoord},
                             {-kMaxCoord, kMaxCoord - 100},
                             {kMaxCoord - 100, kMaxCoord - 100},
                             {0, 0}}) {
    for (Chain chain : contours) {
      chain.origin.x += corner.x;
      chain.origin.y += corner.y;
      chains.push_back(chain);
    }
  }
  const Fitted fitted(chains);
  EXPECT_EQ(swept(fitted), through_grid(fitted));
  EXPECT_EQ(swept(fitted).size(), 5 * swept(Fitted(contours)).size());
  expect_same_lines(chains);
}

/// In linear time, which quadratic time would be beyond any patience.
TEST(SweptPoints, OfManyChainsAtEvenDistancesAreFoundSoon) {
  const std::vector<Chain> contours = contours_of(disc(3));
  for (const Point apart : {Point{0, 2048}, {2048, 0}, {1024, 1024}}) {
    std::vector<Chain> chains;
    for (std::int32_t i = 0; i < 50000; ++i) {
      chains.push_back(contours.front());
      chains.back().origin.x += i * apart.x;
      chains.back().origin.y += i * apart.y;
    }
    EXPECT_TRUE(swept(Fitted(std::move(chains))).empty());
  }
}

TEST(SweptPoints, OfNothingShowNothing) {
  EXPECT_TRUE(swept(Fitted(std::vector<Chain>{})).empty());
  EXPECT_TRUE(swept(Fitted(std::vector<Chain>{open_chain({})})).empty());
}

}  // namespace
}  // namespace unstep::reverse
