#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "reverse/tolerance_lines.h"
#include "unit/reverse_tolerance_chains.h"

namespace unstep::reverse {
namespace {

using namespace testing;

/// Tolerances in 2^-12: whole ones, others, the largest.
const std::vector<std::int64_t> kTolerances{4096, 5000,  6144,
                                            8192, 20480, 32768};

void expect_same(const Chain& chain, const NearDirections& near,
                 PathTolerance tolerance) {
  for (const YAxis axis : {YAxis::up, YAxis::down}) {
    const ChainWalk walk(chain, axis, 1);
    EXPECT_EQ(fit_lines(walk, tolerance), fit_lines(walk, tolerance, &near))
        << tolerance.fixed << ", " << chain.steps.size() << " steps";
  }
}

TEST(NearDirections, GiveTheLinesOfTheConeOfVectors) {
  std::mt19937 random(20);
  for (const std::int64_t fixed : kTolerances) {
    const PathTolerance tolerance{fixed};
    const auto near = std::make_unique<const NearDirections>(tolerance);
    for (int run = 0; run < 120; ++run) {
      const std::size_t steps = 1 + random() % 400;
      const auto turning = static_cast<std::uint32_t>(1 + random() % 12);
      const Chain chain = random_chain(random, steps, turning);
      expect_same(chain, *near, tolerance);
      expect_same(retraced(chain), *near, tolerance);
    }
    for (const std::uint32_t sticking : {40U, 120U, 200U}) {
      for (const Chain& contour : contours_of(blots(random, 48, sticking))) {
        expect_same(contour, *near, tolerance);
      }
    }
    for (const Chain& contour : contours_of(disc(60, 50))) {
      expect_same(contour, *near, tolerance);
    }
  }
}

/// The same chains again and again: what one remembers serves the others.
TEST(LookMemory, GivesTheLinesOfLooking) {
  std::mt19937 random(21);
  for (const std::int64_t fixed : kTolerances) {
    const PathTolerance tolerance{fixed};
    const auto near = std::make_unique<const NearDirections>(tolerance);
    std::vector<Chain> chains = contours_of(disc(40, 33));
    for (const std::uint32_t sticking : {0U, 40U, 120U, 200U}) {
      const auto contours = contours_of(blots(random, 64, sticking));
      chains.insert(chains.end(), contours.begin(), contours.end());
    }
    for (std::size_t i = 0; i < 40; ++i) {
      // 8-connected, for which nothing is remembered, and open ends.
      chains.push_back(random_chain(random, 1 + random() % 100, 6));
      chains.push_back(chains[i % chains.size()]);
      chains.back().closed = false;
      chains.back().steps.resize(chains.back().steps.size() * 2 / 3);
    }
    for (const YAxis axis : {YAxis::up, YAxis::down}) {
      LookMemory memory(1000);
      for (const Chain& chain : chains) {
        const ChainWalk walk(chain, axis, 1);
        EXPECT_EQ(fit_lines(walk, tolerance, near.get()),
                  fit_lines(walk, tolerance, near.get(), &memory))
            << fixed << ", " << chain.steps.size() << " steps";
      }
    }
  }
}

TEST(NearDirections, KeepTheOrderOfVectors) {
  const NearDirections near({4096});
  for (const Point a : {Point{3, 1}, {-7, 2}, {-30, -30}, {5, -29}, {0, 4}}) {
    for (std::int32_t y = -30; y <= 30; ++y) {
      for (std::int32_t x = -30; x <= 30; ++x) {
        if (x == 0 && y == 0) continue;
        const auto turn = static_cast<std::int16_t>(
            near.at(NearDirections::place_of({x, y})).direction -
            near.at(NearDirections::place_of(a)).direction);
        const int cross = a.x * y - a.y * x;
        const bool ahead = a.x * x + a.y * y > 0;
        EXPECT_EQ(turn > 0, cross > 0) << x << ' ' << y;
        EXPECT_EQ(turn == 0, cross == 0 && ahead) << x << ' ' << y;
      }
    }
  }
}

}  // namespace
}  // namespace unstep::reverse
