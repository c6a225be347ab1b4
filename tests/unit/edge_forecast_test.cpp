#include "codec/edge_forecast.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace unstep::codec {
namespace {

constexpr int kEast = 0;
constexpr int kSouth = 1;
constexpr int kWest = 2;

TEST(SlopeRange, NarrowsToTheLinesThroughAllRows) {
  SlopeRange slopes;
  std::uint64_t before = slopes.weight(1);
  for (int dy = 1; dy <= 60; ++dy) {
    const int dx = (2 * dy + 2) / 5;  // 2 / 5, rounded
    slopes.from(dx, dy);
    slopes.up_to(dx, dy);
    EXPECT_LE(slopes.weight(dy), before) << dy;
    before = slopes.weight(dy);
  }
  EXPECT_TRUE(slopes.holds(2, 5));
  EXPECT_FALSE(slopes.holds(1, 2));
  EXPECT_FALSE(slopes.holds(3, 8));
  EXPECT_GT(before, 0U);
}

TEST(SlopeRange, HoldsNothingWhenRowsContradict) {
  SlopeRange slopes;
  slopes.up_to(0, 4);
  slopes.from(3, 5);
  EXPECT_EQ(slopes.weight(5), 0U);
}

TEST(SlopeWeights, AreThoseOfTheRanges) {
  SlopeWeights weights;
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    SlopeRange slopes;
    const int rise = static_cast<int>(random() % 8000) - 4000;
    for (int dy = 1; dy <= 200; dy += 1 + static_cast<int>(random() % 9)) {
      const int dx = rise * dy / 200 + static_cast<int>(random() % 2);
      slopes.from(dx, dy);
      slopes.up_to(dx, dy);
      ASSERT_EQ(weights.of(slopes, dy), slopes.weight(dy));
      ASSERT_EQ(weights.of(slopes, dy), slopes.weight(dy));
    }
  }
}

/// The right edge, ink in the west, of a polygon from (0, 0) to (dx, dy).
std::vector<int> edge(int dx, int dy) {
  std::vector<int> steps{kSouth};
  int x = 0;
  for (int y = 1; y <= dy; ++y) {
    const int next = (2 * y * dx + dy) / (2 * dy);
    for (; x < next; ++x) steps.push_back(kEast);
    steps.push_back(kSouth);
  }
  return steps;
}

TEST(EdgeForecast, IsSureOfTheRestOfALongEdge) {
  for (const int dx : {3, 11, 29, 70}) {
    EdgeForecast forecast;
    forecast.begin(true);
    const std::vector<int> steps = edge(dx, 40);
    forecast.step(steps[0]);
    std::size_t doubted = 0;
    for (std::size_t i = 1; i < steps.size(); ++i) {
      forecast.look();
      const bool bends = steps[i] != steps[i - 1];
      const int truth = bends ? forecast.bends() : 65536 - forecast.bends();
      const bool late = i > steps.size() / 2;
      doubted += late && truth < 32768 ? 1U : 0U;
      if (bends) {
        const bool right = steps[i] == (steps[i - 1] + 1) % 4;
        const int side = right ? forecast.right() : 65536 - forecast.right();
        EXPECT_TRUE(!late || side > 32768) << dx << " step " << i;
      }
      forecast.step(steps[i]);
    }
    EXPECT_LE(doubted, 4U) << dx;
  }
}

TEST(EdgeForecast, KeepsItsRangesOnAnyWalk) {
  std::mt19937 random(7);
  for (int walk = 0; walk < 60; ++walk) {
    EdgeForecast forecast;
    forecast.begin(walk % 2 == 0);
    int direction = kEast;
    for (int i = 0; i < 2000; ++i) {
      const unsigned chance = walk % 5 == 0 ? 200 : 3;
      if (random() % chance == 0) {
        direction = (direction + (random() % 2 == 0 ? 1 : 3)) % 4;
      }
      forecast.step(direction);
      forecast.look();
      ASSERT_GE(std::min(forecast.bends(), forecast.right()), 60);
      ASSERT_LE(std::max(forecast.bends(), forecast.right()), 65476);
      ASSERT_LE(forecast.age(), 200);
      ASSERT_GE(forecast.age(), 0);
      ASSERT_LE(forecast.vertex(), 255U);
      ASSERT_LT(forecast.place(), std::uint64_t{1} << 20);
    }
  }
}

TEST(EdgeForecast, BeginsEveryWalkAnew) {
  EdgeForecast used;
  EdgeForecast fresh;
  used.begin(true);
  for (const int step : edge(20, 50)) used.step(step);
  for (EdgeForecast* forecast : {&used, &fresh}) {
    forecast->begin(false);
    for (const int step : {kSouth, kSouth, kWest, kSouth}) {
      forecast->step(step);
    }
    forecast->look();
  }
  EXPECT_EQ(used.bends(), fresh.bends());
  EXPECT_EQ(used.right(), fresh.right());
  EXPECT_EQ(used.place(), fresh.place());
}

}  // namespace
}  // namespace unstep::codec
