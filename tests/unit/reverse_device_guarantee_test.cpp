#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

#include "unit/device_search.h"
#include "unstep/interpolate.h"
#include "unstep/reverse.h"

namespace unstep {
namespace {

using testing::Axis;
using testing::deviation;
using testing::Search;

TEST(DeviceGuarantee, HoldsForEveryPathOfUpTo20Steps) {
  Search search{20};
  std::vector<std::uint8_t> word;
  search.all_paths({}, word, 0);
  EXPECT_EQ(search.words, (1U << 21) - 2) << "every path of 1..20 steps";
  EXPECT_EQ(search.worst, 1);
}

// With the lemma: every chain whose segments have at most 256 steps.
TEST(DeviceGuarantee, HoldsForEveryOneSegmentWordOfUpTo256Steps) {
  Search search{256};
  std::vector<std::uint8_t> word;
  search.one_segment({}, word);
  EXPECT_EQ(search.words, 3439670U);
  EXPECT_EQ(search.worst, 1);
}

// Long segments: the letter is forced unless F == 0, and random there.
TEST(DeviceGuarantee, HoldsForRandomOneSegmentWordsOfUpTo100000Steps) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    std::vector<std::uint8_t> word;
    DeviceRegisters device;
    const std::size_t length = 1000 + random() % 100'000;
    const unsigned bias = std::array{2U, 10U, 100U}[random() % 3];
    while (word.size() < length) {
      const bool along_y =
          device.f > 0 || (device.f == 0 && random() % bias == 0);
      EXPECT_FALSE(device.accept(along_y ? Axis::y : Axis::x));
      word.push_back(along_y);
    }
    ASSERT_LE(deviation(device.x, device.y, word), 1) << round;
  }
}

// Largest deviation, both axes, of forward(reverse(chain)) from the chain.
std::int64_t chain_deviation(const std::vector<Step>& chain) {
  std::int64_t worst = 0;
  std::int64_t cx = 0, cy = 0, lx = 0, ly = 0;
  std::size_t at = 0;
  const auto draw = [&](Segment segment) {
    DeviceRegisters device;
    device.start(std::abs(std::int64_t{segment.dx}),
                 std::abs(std::int64_t{segment.dy}));
    while (device.forward) {
      if (device.clock() == Axis::x)
        lx += segment.dx < 0 ? -1 : 1;
      else
        ly += segment.dy < 0 ? -1 : 1;
      const Point move = step_delta(chain[at++]);
      cx += move.x;
      cy += move.y;
      worst = std::max({worst, std::abs(cx - lx), std::abs(cy - ly)});
    }
    EXPECT_EQ(cx, lx);
    EXPECT_EQ(cy, ly);
  };
  DeviceReverse device;
  Segment closed;
  for (const Step step : chain)
    if (device.push(step, closed) == Pushed::segment) draw(closed);
  if (device.finish(closed)) draw(closed);
  EXPECT_EQ(at, chain.size()) << "every step is drawn again";
  return worst;
}

TEST(DeviceGuarantee, HoldsForRandomChainsOfTenMillionSteps) {
  std::mt19937_64 random(22);
  for (const unsigned kind : {0U, 1U, 2U}) {
    std::vector<Step> chain(10'000'000);
    Step last = 0;
    std::uint64_t slope = 1;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (i % 4096 == 0) slope = random() % 1024;
      const std::uint64_t r = random();
      if (kind == 0) {
        last = static_cast<Step>(r % 4 * 2);  // a drunkard
      } else if (kind == 1) {
        if (r % 8 == 0) last = static_cast<Step>(r / 8 % 4 * 2);  // runs
      } else {
        last = r % 1024 < slope ? 2 : 0;  // noisy lines
      }
      chain[i] = last;
    }
    EXPECT_EQ(chain_deviation(chain), 1) << "kind " << kind;
  }
}

// The 4-connected circle whose points are nearest to the radius, one round.
std::vector<Step> circle(std::int64_t radius) {
  std::vector<Step> chain;
  std::int64_t a = 0, b = radius, f = 0;
  std::vector<bool> quarter;  // true: a step along the growing axis
  while (b > 0) {
    const std::int64_t grow = f + 2 * a + 1, shrink = f - 2 * b + 1;
    const bool grows = std::abs(grow) <= std::abs(shrink);
    f = grows ? grow : shrink;
    grows ? ++a : --b;
    quarter.push_back(grows);
  }
  for (Step turn = 0; turn < 4; ++turn)
    for (const bool grows : quarter)
      chain.push_back(static_cast<Step>((grows ? turn * 2 : turn * 2 + 6) % 8));
  return chain;
}

TEST(DeviceGuarantee, HoldsForCirclesUpToRadius100000) {
  for (std::int64_t r = 1; r <= 300; ++r)
    EXPECT_LE(chain_deviation(circle(r)), 1) << r;
  for (const std::int64_t r : {1000, 4096, 9999, 31415, 65536, 99999, 100000})
    EXPECT_LE(chain_deviation(circle(r)), 1) << r;
}

}  // namespace
}  // namespace unstep
