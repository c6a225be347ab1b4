#include "codec/curve_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

namespace unstep::codec {
namespace {

/// A walk that a fit sees.
struct Walk {
  CurveFit fit;
  std::int32_t x = 0;
  std::int32_t y = 0;
  Quarter direction = 0;

  void go(Quarter d, const CurveFit::Gaps& gaps) {
    direction = d;
    x += kQuarterDx[static_cast<std::size_t>(d)];
    y += kQuarterDy[static_cast<std::size_t>(d)];
    fit.step(d, x, y, gaps);
  }
  [[nodiscard]] CurveFit::Forecast ask(std::size_t axis,
                                       const CurveFit::Gaps& gaps) const {
    return fit.forecast(axis, direction, x, y, gaps);
  }
};

/// In eighths of a unit; less than 0 if a forecast holds none.
int eighths(std::uint64_t forecast) {
  const auto level = static_cast<int>(forecast >> 8);
  return level < 8 ? -1 : (level - 8) >> 2;
}

/// How far on the curve y = f(x) is above the walk at the next step east, in
/// the fit's eighths: 128 and half a unit are added.
int wanted(double ahead) {
  return static_cast<int>(std::floor((ahead * 64 + 32 + 128) / 8));
}

template <class Curve>
void follow(Walk& walk, Curve curve, int columns) {
  for (int i = 0; i < columns; ++i) {
    const auto next = static_cast<std::int32_t>(std::lround(curve(walk.x)));
    while (walk.y < next) walk.go(1, {0, 0});
    while (walk.y > next) walk.go(3, {0, 0});
    walk.go(0, {0, 0});
  }
}

TEST(CurveFit, ForeseesALineAndAParabola) {
  for (const double bend : {0.0, 0.004, -0.006}) {
    for (const double slope : {0.0, 0.31, -0.77}) {
      Walk walk;
      const auto curve = [&](double x) { return slope * x + bend * x * x; };
      follow(walk, curve, 60);
      const double ahead = curve(walk.x) - walk.y;
      // Steps are rounded, so the fit is as good as half a unit.
      EXPECT_NEAR(eighths(walk.ask(0, {0, 0}).curve), wanted(ahead), 4)
          << slope << " " << bend;
    }
  }
}

TEST(CurveFit, KnowsNothingAtFirstAndAfterATurnBack) {
  Walk walk;
  walk.fit.begin();
  walk.go(0, {0, 0});
  EXPECT_LT(eighths(walk.ask(0, {0, 0}).curve), 0);
  for (int i = 0; i < 10; ++i) walk.go(0, {0, 0});
  EXPECT_GE(eighths(walk.ask(0, {0, 0}).curve), 0);
  walk.go(1, {0, 0});
  walk.go(2, {0, 0});
  EXPECT_LT(eighths(walk.ask(0, {0, 0}).curve), 0);
}

TEST(CurveFit, FollowsTheOtherSideOfAStroke) {
  Walk walk;
  for (int i = 0; i < 20; ++i) walk.go(0, {7, 0});
  // The other side comes one unit nearer: this one should give way by one.
  const int same = eighths(walk.ask(0, {7, 0}).right);
  EXPECT_EQ(same, wanted(0));
  EXPECT_EQ(eighths(walk.ask(0, {8, 0}).right), same + 8);
  EXPECT_EQ(eighths(walk.ask(0, {6, 0}).right), same - 8);
  EXPECT_LT(eighths(walk.ask(0, {0, 0}).right), 0);
  EXPECT_LT(eighths(walk.ask(0, {7, 0}).left), 0);
}

TEST(CurveFit, SeesAWalkAlikeFromAllQuarters) {
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    std::array<Walk, 4> walks;
    for (int i = 0; i < 80; ++i) {
      const Quarter d = random() % 3 == 0 ? 1 : 0;
      const int right = static_cast<int>(random() % 2) * 5;
      for (int q = 0; q < 4; ++q) {
        const Quarter turned = (d + q) & 3;
        // Right is towards greater coordinates going east and north.
        const bool greater = turned == 0 || turned == 3;
        walks[static_cast<std::size_t>(q)].go(
            turned,
            greater ? CurveFit::Gaps{right, 0} : CurveFit::Gaps{0, right});
      }
      const std::uint64_t first = walks[0].ask(0, {0, 0}).curve;
      for (std::size_t q = 1; q < 4; ++q) {
        const std::uint64_t other = walks[q].ask(q & 1, {0, 0}).curve;
        // Rounding is downwards for all, so a little may differ.
        EXPECT_EQ(first >> 2 & 63, other >> 2 & 63);
        EXPECT_NEAR(eighths(first), eighths(other), 1);
      }
    }
  }
}

TEST(CurveFit, BearsLongStepsAndFarPlaces) {
  CurveFit fit;
  fit.begin();
  constexpr std::int32_t kFar = 1 << 30;
  fit.step(0, kFar, kFar - 1, {0, 0});
  fit.step(0, -kFar, 1 - kFar, {0, 0});
  for (std::int32_t i = 0; i < 40; ++i) fit.step(0, i, i % 2 * 1000, {40, 40});
  EXPECT_LT(fit.forecast(0, 0, kFar, -kFar, {40, 1}).curve, 1U << 16);
}

}  // namespace
}  // namespace unstep::codec
