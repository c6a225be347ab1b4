#include <gtest/gtest.h>

#include <algorithm>

#include "machine/chain_follower.h"
#include "machine/ink_distance.h"

namespace unstep::machine {
namespace {

Chain square(int side) {
  Chain chain{{5, 7}, Connectivity::four, true, {}};
  for (const int step : {0, 6, 4, 2})
    chain.steps.insert(chain.steps.end(), static_cast<std::size_t>(side),
                       static_cast<Step>(step));
  return chain;
}

FollowReport follow(const FollowOptions& options) {
  const std::vector<Chain> chains{square(60)};
  const auto report =
      follow_chains(chains, YAxis::down, options,
                    [](std::size_t, double, double) { return true; });
  EXPECT_TRUE(report);
  return report ? *report : FollowReport{};
}

TEST(ChainFollower, RoundsCornersTheMoreTheFasterItIs) {
  double before = 0;
  for (const double speed : {300.0, 1000.0, 3000.0}) {
    FollowOptions options;
    options.speed_um = speed;
    const FollowReport report = follow(options);
    EXPECT_EQ(report.steps, 240U);
    EXPECT_NEAR(report.lit_seconds, 240 * 4 / speed, 0.3);
    EXPECT_DOUBLE_EQ(report.peak_steps_hz, speed / 4);
    EXPECT_GT(report.worst_um, before);
    EXPECT_LT(report.worst_um, speed * 0.006);
    EXPECT_LE(report.rms_um, report.worst_um);
    EXPECT_EQ(report.broken, BrokenLimits{});
    before = report.worst_um;
  }
}

TEST(ChainFollower, SaysWhichLimitsAreBroken) {
  FollowOptions options;
  options.speed_um = 15'000;
  const FollowReport report = follow(options);
  EXPECT_TRUE(report.broken.axis_speed);
  EXPECT_GT(report.broken.saturated_seconds, 0);
}

TEST(ChainFollower, VisitsTheWholeChainInGridUnits) {
  const std::vector<Chain> chains{square(60), Chain{{2, 3}, {}, false, {1}}};
  double left = 1e9;
  double bottom = -1e9;
  std::size_t last = 0;
  const auto report = follow_chains(chains, YAxis::down, {},
                                    [&](std::size_t chain, double x, double y) {
                                      last = chain;
                                      if (chain == 0) {
                                        left = std::min(left, x);
                                        bottom = std::max(bottom, y);
                                      }
                                      return true;
                                    });
  ASSERT_TRUE(report);
  EXPECT_NEAR(left, 5, 0.5);
  EXPECT_NEAR(bottom, 67, 0.5);
  EXPECT_EQ(last, 1U);
}

TEST(ChainFollower, StopsWhenToldAndRefusesWhatItCannotReach) {
  const auto code = [](Point origin, const FollowOptions& options, bool go) {
    const std::vector<Chain> chains{Chain{origin, {}, false, {0}}};
    const auto report =
        follow_chains(chains, YAxis::down, options,
                      [go](std::size_t, double, double) { return go; });
    return report ? ErrorCode::io_error : report.error().code;
  };
  FollowOptions options;
  EXPECT_EQ(code({0, 0}, options, false), ErrorCode::cancelled);
  EXPECT_EQ(code({-200'000, 0}, options, true), ErrorCode::out_of_range);
  EXPECT_EQ(code({0, kMaxCoord}, options, true), ErrorCode::out_of_range);
  options.unit_pulses = 12;
  EXPECT_EQ(code({0, 0}, options, true), ErrorCode::out_of_range);
  options.unit_pulses = 13;
  options.speed_um = 19;
  EXPECT_EQ(code({0, 0}, options, true), ErrorCode::out_of_range);
}

TEST(InkDistance, MeasuresBothWays) {
  Bitmap a = *Bitmap::create(100, 100);
  Bitmap b = *Bitmap::create(100, 100);
  EXPECT_EQ(ink_distance(a, b).worst, 0);
  a.set(50, 50, true);
  EXPECT_EQ(ink_distance(a, b).lost, 1U);
  b.set(53, 54, true);
  const InkDistance distance = ink_distance(a, b);
  EXPECT_EQ(distance.differing, 2U);
  EXPECT_DOUBLE_EQ(distance.worst, 5);
  EXPECT_DOUBLE_EQ(distance.rms, 5);
  EXPECT_EQ(distance.lost, 0U);
  b.set(50, 50, true);
  EXPECT_EQ(ink_distance(a, b).differing, 1U);
}

}  // namespace
}  // namespace unstep::machine
