#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "interpolate/rate_multiplier.h"
#include "unit/interpolate_oracle.h"
#include "unit/method_test_name.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

using oracle::Trace;

constexpr std::int32_t kMin = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();

Interpolator line(Method method, Segment segment,
                  const InterpolatorOptions& options = {}) {
  auto result = Interpolator::line(method, segment, options);
  EXPECT_TRUE(result) << result.error().message;
  return *result;
}

std::string word(Method method, Segment segment,
                 const InterpolatorOptions& options = {}) {
  std::string letters;
  Interpolator run = line(method, segment, options);
  for (Tick t = run.next(); t.kind != Tick::Kind::done; t = run.next())
    letters +=
        t.kind == Tick::Kind::idle ? '.' : static_cast<char>('0' + t.step);
  return letters;
}

// The bound every method states in docs/algorithms.md, in units.
long double stated_bound(Method method) {
  switch (method) {
    case Method::evaluation8: return 0.5L;
    case Method::cordic:
    case Method::meggitt:
    case Method::rom:
    case Method::general: return 0.75L;
    default: return 1.0L;
  }
}

class LineMethods : public testing::TestWithParam<Method> {};

TEST_P(LineMethods, ReachTheEndWithinTheStatedDeviation) {
  const Method method = GetParam();
  std::vector<Segment> segments;
  for (std::int32_t x = -24; x <= 24; ++x)
    for (std::int32_t y = -24; y <= 24; ++y) segments.push_back({x, y});
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    const std::int32_t range = i < 50 ? 2000 : 200'000;
    std::uniform_int_distribution<std::int32_t> delta(-range, range);
    segments.push_back({delta(random), delta(random)});
  }
  for (const double feed : {1.0, 16.0, 333.0}) {
    InterpolatorOptions options;
    options.feed = feed;
    if (feed != 16.0 && !method_info(method).increments) continue;
    for (const Segment s : segments) {
      const Trace t = oracle::follow_line(line(method, s, options), s, 1 << 20);
      ASSERT_TRUE(t.legal) << s.dx << ',' << s.dy;
      ASSERT_EQ(t.x, s.dx) << s.dx << ',' << s.dy;
      ASSERT_EQ(t.y, s.dy) << s.dx << ',' << s.dy;
      if (method == Method::rate_multiplier) {
        const int n = interpolation::RateMultiplier::bits_for(s);
        ASSERT_LE(t.worst, n / std::sqrt(2.0L)) << s.dx << ',' << s.dy;
      } else {
        ASSERT_LE(t.worst, stated_bound(method)) << s.dx << ',' << s.dy;
      }
    }
  }
}

TEST_P(LineMethods, DrawNothingForAZeroSegment) {
  Interpolator run = line(GetParam(), {0, 0});
  EXPECT_EQ(run.next().kind, Tick::Kind::done);
  EXPECT_EQ(run.next().kind, Tick::Kind::done);
}

TEST_P(LineMethods, AreSymmetricInAllQuadrants) {
  for (const Segment s : {Segment{7, 3}, {2, 9}, {5, 5}, {0, 6}, {8, 0}}) {
    for (const std::int32_t sx : {1, -1}) {
      for (const std::int32_t sy : {1, -1}) {
        Interpolator first = line(GetParam(), s);
        Interpolator other = line(GetParam(), {sx * s.dx, sy * s.dy});
        Tick a;
        do {
          a = first.next();
          const Tick b = other.next();
          ASSERT_EQ(a.kind, b.kind);
          ASSERT_EQ(a.dx * sx, b.dx);
          ASSERT_EQ(a.dy * sy, b.dy);
        } while (a.kind != Tick::Kind::done);
      }
    }
  }
}

TEST_P(LineMethods, KeepTheirDeviationOverTheFirstStepsOfTheLongestLines) {
  const Method method = GetParam();
  InterpolatorOptions options;
  options.feed = 1000;
  for (const Segment s : {Segment{kMin, kMin},
                          {kMin, kMax},
                          {kMax, kMin},
                          {kMax, 1},
                          {-1, kMin},
                          {0, kMin},
                          {kMax, 1 << 30}}) {
    Interpolator run = line(method, s, options);
    const long double length = std::hypot(static_cast<long double>(s.dx),
                                          static_cast<long double>(s.dy));
    std::int64_t x = 0, y = 0;
    long double worst = 0;
    for (int i = 0; i < 200'000; ++i) {
      const Tick t = run.next();
      ASSERT_TRUE(oracle::legal_tick(t));
      if (t.kind == Tick::Kind::done) break;
      x += t.dx;
      y += t.dy;
      worst = std::max(worst, std::abs(static_cast<long double>(x) *
                                           static_cast<long double>(s.dy) -
                                       static_cast<long double>(y) *
                                           static_cast<long double>(s.dx)) /
                                  length);
    }
    EXPECT_LE(worst, method == Method::rate_multiplier ? 32 / std::sqrt(2.0L)
                                                       : stated_bound(method))
        << s.dx << ',' << s.dy;
  }
}

TEST_P(LineMethods, FillGivesTheSameTicksAsNext) {
  Interpolator one = line(GetParam(), {-123, 77});
  Interpolator many = one;
  std::vector<Tick> block(10);
  std::size_t n = 0;
  do {
    n = many.fill(block);
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(one.next(), block[i]);
  } while (n == block.size());
  EXPECT_EQ(one.next().kind, Tick::Kind::done);
}

INSTANTIATE_TEST_SUITE_P(
    All, LineMethods,
    testing::Values(Method::device, Method::gate_level, Method::rate_multiplier,
                    Method::evaluation, Method::evaluation8, Method::increments,
                    Method::cordic, Method::meggitt, Method::rom,
                    Method::general),
    oracle::test_name);

TEST(RateMultiplier, FiresTheFourBitDevicesStagesInTheirOrder) {
  InterpolatorOptions options;
  options.rate_bits = 4;
  // 5 = 0101: bit 2 belongs to stage 1 (pulses 2, 6, 10, 14), bit 0 to stage
  // 3 (pulse 8). 8 = 1000: stage 0, the odd pulses.
  EXPECT_EQ(word(Method::rate_multiplier, {5, 0}, options), ".0...0.0.0...0..");
  EXPECT_EQ(word(Method::rate_multiplier, {0, 8}, options), "2.2.2.2.2.2.2.2.");
  EXPECT_EQ(word(Method::rate_multiplier, {15, -15}, options),
            "777777777777777.");
  EXPECT_EQ(word(Method::rate_multiplier, {0, 0}, options), "................");
}

TEST(RateMultiplier, MakesFramesOf16PulsesWithExactlyDPulsesPerAxis) {
  InterpolatorOptions options;
  options.rate_bits = 4;
  for (std::int32_t x = -15; x <= 15; ++x) {
    for (std::int32_t y = -15; y <= 15; ++y) {
      const Trace t = oracle::follow_line(
          line(Method::rate_multiplier, {x, y}, options), {x, y});
      ASSERT_EQ(t.ticks, 16U);
      ASSERT_EQ(t.x, x);
      ASSERT_EQ(t.y, y);
    }
  }
}

TEST(RateMultiplier, StaysWithinHalfAUnitPerStageOnEachAxis) {
  for (int n = 1; n <= 10; ++n) {
    InterpolatorOptions options;
    options.rate_bits = n;
    for (std::int32_t d = 0; d < 1 << n; ++d) {
      Interpolator run = line(Method::rate_multiplier, {d, 0}, options);
      int moved = 0;
      for (int k = 1; k <= 1 << n; ++k) {
        moved += run.next().dx;
        const double share = static_cast<double>(d) * k / (1 << n);
        ASSERT_LE(std::abs(moved - share), n / 2.0) << n << ' ' << d;
      }
    }
  }
}

TEST(RateMultiplier, RefusesADeltaThatItsRegistersCannotHold) {
  InterpolatorOptions options;
  options.rate_bits = 4;
  const auto run =
      Interpolator::line(Method::rate_multiplier, {16, 1}, options);
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, ErrorCode::out_of_range);
  EXPECT_NE(run.error().message.find("(16, 1) needs registers of 5 bits"),
            std::string::npos);
  for (const int bits : {-1, 33}) {
    options.rate_bits = bits;
    EXPECT_FALSE(Interpolator::line(Method::rate_multiplier, {1, 1}, options));
  }
}

TEST(Evaluation, TakesItsFirstStepAlongXAndThenFollowsTheSign) {
  EXPECT_EQ(word(Method::evaluation, {7, 3}), "0200200200");
  EXPECT_EQ(word(Method::evaluation, {2, 2}), "0202");
  EXPECT_EQ(word(Method::evaluation, {1, 3}), "0222");
}

TEST(Evaluation, StepsYOnlyWhenXkIsZero) {
  EXPECT_EQ(word(Method::evaluation, {0, 4}), "2222");
  EXPECT_EQ(word(Method::evaluation, {0, -2}), "66");
}

TEST(Evaluation, ShowsItsRegisters) {
  Interpolator run = line(Method::evaluation, {7, 3});
  run.next();
  std::array<Register, kMaxRegisters> r;
  ASSERT_EQ(run.registers(r), 3U);
  EXPECT_EQ(r[0], (Register{"x", 1}));
  EXPECT_EQ(r[1], (Register{"y", 0}));
  EXPECT_EQ(r[2], (Register{"F", -3}));
}

TEST(Evaluation8, MakesOneTickPerUnitOfTheMajorAxisInEveryOctant) {
  for (std::int32_t x = -30; x <= 30; ++x) {
    for (std::int32_t y = -30; y <= 30; ++y) {
      const Trace t =
          oracle::follow_line(line(Method::evaluation8, {x, y}), {x, y});
      const auto major =
          static_cast<std::uint64_t>(std::max(std::abs(x), std::abs(y)));
      ASSERT_EQ(t.ticks, major);
      ASSERT_EQ(t.diagonal,
                static_cast<std::uint64_t>(std::min(std::abs(x), std::abs(y))));
    }
  }
}

TEST(Methods, HaveUniqueNamesThatAreFound) {
  std::set<std::string_view> names;
  for (const MethodInfo& info : methods()) {
    EXPECT_TRUE(names.insert(info.name).second);
    EXPECT_EQ(find_method(info.name), info.method);
    EXPECT_EQ(method_info(info.method).name, info.name);
    EXPECT_TRUE(info.lines || info.arcs);
    EXPECT_EQ(Interpolator::line(info.method, {1, 1}).operator bool(),
              info.lines);
    EXPECT_EQ(Interpolator::arc(info.method, {{5, 0}, {0, 0}}).operator bool(),
              info.arcs);
  }
  EXPECT_EQ(find_method("bresenham"), std::nullopt);
}

}  // namespace
}  // namespace unstep
