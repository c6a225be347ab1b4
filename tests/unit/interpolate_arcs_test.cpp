#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "interpolate/arc_steps.h"
#include "interpolate/arc_walk.h"
#include "interpolate/circular.h"
#include "unit/interpolate_oracle.h"
#include "unit/method_test_name.h"
#include "unstep/interpolate.h"

namespace unstep {
namespace {

using oracle::Trace;

Interpolator arc_of(Method method, const Arc& arc,
                    const InterpolatorOptions& options = {}) {
  auto result = Interpolator::arc(method, arc, options);
  EXPECT_TRUE(result) << result.error().message;
  return *result;
}

std::string text(const Arc& arc) {
  return "centre (" + std::to_string(arc.centre.x) + ", " +
         std::to_string(arc.centre.y) + ") end (" + std::to_string(arc.end.x) +
         ", " + std::to_string(arc.end.y) + ")" +
         (arc.clockwise ? " cw" : " ccw");
}

void check(Method method, const Arc& arc, const InterpolatorOptions& options,
           long double bound) {
  const Trace t =
      oracle::follow_arc(arc_of(method, arc, options), arc, 1 << 22);
  const auto x = static_cast<long double>(arc.centre.x);
  const auto y = static_cast<long double>(arc.centre.y);
  const long double radius = std::hypot(x, y);
  ASSERT_TRUE(t.legal) << text(arc);
  ASSERT_EQ(t.x, arc.end.x) << text(arc);
  ASSERT_EQ(t.y, arc.end.y) << text(arc);
  ASSERT_LE(t.worst, bound) << text(arc);
  // Long increments around a small circle do not show the angle they swept.
  const double path = options.feed * options.period;
  if (radius > 3 && (!method_info(method).increments || radius > 2 * path)) {
    ASSERT_NEAR(static_cast<double>(t.swept),
                static_cast<double>(oracle::arc_sweep(arc)),
                static_cast<double>(3 / radius))
        << text(arc);
  }
}

class ArcMethods : public testing::TestWithParam<Method> {};

TEST_P(ArcMethods, DrawEverySmallArcWithinOneUnit) {
  for (std::int32_t cx = -6; cx <= 6; ++cx)
    for (std::int32_t cy = -6; cy <= 6; ++cy)
      for (std::int32_t ex = -13; ex <= 13; ++ex)
        for (std::int32_t ey = -13; ey <= 13; ++ey)
          for (const bool clockwise : {true, false}) {
            const Arc arc{{cx, cy}, {ex, ey}, clockwise};
            if (Interpolator::arc(GetParam(), arc))
              check(GetParam(), arc, {}, 1.0L);
          }
}

TEST_P(ArcMethods, DrawRandomArcsAndFullCirclesWithinTheStatedDeviation) {
  // Ends at the grid point nearest to the circle.
  const long double bound =
      GetParam() == Method::circular || GetParam() == Method::increments
          ? 1.0L
          : 0.75L;
  std::mt19937 random(9);
  for (const double feed : {1.0, 16.0, 50.0}) {
    InterpolatorOptions options;
    options.feed = feed;
    for (const std::int32_t span : {30, 300, 3000, 30'000}) {
      std::uniform_int_distribution<std::int32_t> coordinate(-span, span);
      for (int i = 0; i < (span < 5000 ? 12 : 2); ++i) {
        Arc arc{{coordinate(random), coordinate(random)}, {0, 0}, i % 2 == 0};
        if (arc.centre == Point{}) continue;
        ASSERT_NO_FATAL_FAILURE(check(GetParam(), arc, options, bound));
        const double radius = std::hypot(arc.centre.x, arc.centre.y);
        const double angle = static_cast<double>(random()) * 1e-9;
        arc.end.x = static_cast<std::int32_t>(
            std::lround(arc.centre.x + radius * std::cos(angle)));
        arc.end.y = static_cast<std::int32_t>(
            std::lround(arc.centre.y + radius * std::sin(angle)));
        ASSERT_NO_FATAL_FAILURE(check(GetParam(), arc, options, bound));
      }
    }
  }
}

TEST_P(ArcMethods, KeepTheirDeviationOnTheLargestCircles) {
  InterpolatorOptions options;
  options.feed = 1e6;
  for (const Point centre : {Point{kMaxCoord, kMaxCoord},
                             {-kMaxCoord, 0},
                             {kMaxCoord, -1},
                             {1 << 24, 3}}) {
    for (const bool clockwise : {true, false}) {
      Interpolator run =
          arc_of(GetParam(), {centre, {0, 0}, clockwise}, options);
      const auto cx = static_cast<long double>(centre.x);
      const auto cy = static_cast<long double>(centre.y);
      const long double radius = std::hypot(cx, cy);
      long double x = 0, y = 0, worst = 0;
      for (int i = 0; i < 20'000; ++i) {
        const Tick t = run.next();
        ASSERT_TRUE(oracle::legal_tick(t));
        if (t.kind == Tick::Kind::done) break;
        x += static_cast<long double>(t.dx);
        y += static_cast<long double>(t.dy);
        worst = std::max(worst, std::abs(std::hypot(x - cx, y - cy) - radius));
      }
      EXPECT_LE(worst, 1.0L) << centre.x << ',' << centre.y;
    }
  }
}

TEST_P(ArcMethods, RefuseAnEndOffTheCircle) {
  for (const Arc& arc : {Arc{{10, 0}, {22, 0}}, Arc{{10, 0}, {18, 0}},
                         Arc{{3, 4}, {100, 100}}}) {
    const auto run = Interpolator::arc(GetParam(), arc);
    ASSERT_FALSE(run);
    EXPECT_EQ(run.error().code, ErrorCode::invalid_argument);
    EXPECT_NE(run.error().message.find("is not on the circle"),
              std::string::npos);
  }
  for (const std::int32_t end : {19, 20, 21})
    EXPECT_TRUE(Interpolator::arc(GetParam(), {{10, 0}, {end, 0}})) << end;
}

TEST_P(ArcMethods, RefuseRadiusZeroAndCentresOutOfRange) {
  const Arc zero{{0, 0}, {0, 0}};
  const Arc far{{kMaxCoord + 1, 0}, {0, 0}};
  for (const Arc& arc : {zero, far}) {
    const auto run = Interpolator::arc(GetParam(), arc);
    ASSERT_FALSE(run);
    EXPECT_EQ(run.error().code, ErrorCode::out_of_range);
  }
}

INSTANTIATE_TEST_SUITE_P(All, ArcMethods,
                         testing::Values(Method::circular, Method::increments,
                                         Method::cordic, Method::meggitt,
                                         Method::rom, Method::general),
                         oracle::test_name);

// SEEDS D1: a+: F += 2a + 1; b-: F += -2b + 1; both: F += 2(a - b) + 2.
TEST(Circular, KeepsFEqualToTheEquationInEveryPiece) {
  for (const bool combined : {false, true}) {
    for (const Point centre : {Point{-13, 9}, {0, 25}, {8, 8}, {3, -1000}}) {
      InterpolatorOptions options;
      options.combined = combined;
      Interpolator run = arc_of(Method::circular, {centre, {0, 0}}, options);
      const std::int64_t squared =
          std::int64_t{centre.x} * centre.x + std::int64_t{centre.y} * centre.y;
      std::array<Register, kMaxRegisters> r;
      while (run.next().kind != Tick::Kind::done) {
        ASSERT_EQ(run.registers(r), 4U);
        const std::int64_t a = r[0].value;
        const std::int64_t b = r[1].value;
        ASSERT_GE(a, 0);
        ASSERT_GE(b, 0);
        ASSERT_EQ(r[2].value, a * a + b * b - squared);
      }
    }
  }
}

TEST(Circular, StepsOneAxisUnlessDiagonalsAreAsked) {
  const Arc arc{{-50, 20}, {0, 0}};
  const Trace single = oracle::follow_arc(arc_of(Method::circular, arc), arc);
  EXPECT_EQ(single.diagonal, 0U);
  InterpolatorOptions options;
  options.combined = true;
  const Trace combined =
      oracle::follow_arc(arc_of(Method::circular, arc, options), arc);
  EXPECT_GT(combined.diagonal, 0U);
  EXPECT_LT(combined.ticks, single.ticks);
  EXPECT_LT(combined.worst, single.worst);
}

/// What Circular draws tick by tick, at most `most` steps.
std::vector<Step> ticks_of(const Arc& arc, bool combined, std::size_t most) {
  InterpolatorOptions options;
  options.combined = combined;
  Interpolator run = arc_of(Method::circular, arc, options);
  std::vector<Step> steps;
  for (Tick t = run.next(); t.kind != Tick::Kind::done && steps.size() < most;
       t = run.next())
    steps.push_back(t.step);
  return steps;
}

/// The same in bulk, in pieces of `piece`.
std::vector<Step> bulk_of(const Arc& arc, bool combined, std::size_t most,
                          std::size_t piece) {
  interpolation::ArcSteps run(*interpolation::check_arc(arc), combined,
                              interpolation::kFreemanLetters);
  std::vector<Step> steps(most);
  std::size_t count = 0;
  while (count < most) {
    const std::size_t room = std::min(piece, most - count);
    const std::size_t n = run.fill(std::span(steps).subspan(count, room));
    count += n;
    if (n < room) break;
  }
  steps.resize(count);
  return steps;
}

TEST(ArcSteps, AreThoseOfCircularForEverySmallArc) {
  for (std::int32_t cx = -6; cx <= 6; ++cx)
    for (std::int32_t cy = -6; cy <= 6; ++cy)
      for (std::int32_t ex = -13; ex <= 13; ++ex)
        for (std::int32_t ey = -13; ey <= 13; ++ey)
          for (const unsigned kind : {0U, 1U, 2U, 3U}) {
            const Arc arc{{cx, cy}, {ex, ey}, kind % 2 == 0};
            if (!interpolation::check_arc(arc)) continue;
            ASSERT_EQ(bulk_of(arc, kind > 1, 200, 7),
                      ticks_of(arc, kind > 1, 200))
                << text(arc);
          }
}

TEST(ArcSteps, AreThoseOfCircularForRandomAndLargestArcs) {
  std::mt19937 random(4);
  for (const std::int32_t span : {30, 1000, 30'000, kMaxCoord / 2}) {
    std::uniform_int_distribution<std::int32_t> coordinate(-span, span);
    for (int i = 0; i < 40; ++i) {
      Arc arc{{coordinate(random), coordinate(random)}, {0, 0}, i % 2 == 0};
      if (arc.centre == Point{}) continue;
      const double radius = std::hypot(arc.centre.x, arc.centre.y);
      const double angle = static_cast<double>(random()) * 1e-9;
      if (i % 5 != 0) {
        arc.end.x = static_cast<std::int32_t>(
            std::lround(arc.centre.x + radius * std::cos(angle)));
        arc.end.y = static_cast<std::int32_t>(
            std::lround(arc.centre.y + radius * std::sin(angle)));
      }
      ASSERT_EQ(bulk_of(arc, i % 3 != 0, 20'000, 4999),
                ticks_of(arc, i % 3 != 0, 20'000))
          << text(arc);
    }
  }
}

TEST(Circular, CorrectsTheFeedWithEveryStep) {
  interpolation::ArcGeometry geometry =
      *interpolation::check_arc({{-300, 400}, {0, 0}});
  interpolation::Circular run(geometry, 70.0, false);
  interpolation::ArcWalk walk(geometry);
  // f = Vk (a + b) / R at every step, by corrections of Vk / R alone.
  std::array<Register, kMaxRegisters> r;
  for (int i = 0; i < 3000; ++i) {
    if (run.next().kind == Tick::Kind::done) break;
    run.registers(r);
    const auto sum = static_cast<double>(r[0].value + r[1].value);
    ASSERT_NEAR(run.frequency(), 70.0 * sum / 500.0, 1e-6);
  }
}

TEST(ArcWalk, SplitsAnArcIntoOnePiecePerQuadrant) {
  // Clockwise from (0, 5) about the origin: the circle has four pieces.
  interpolation::ArcWalk walk(*interpolation::check_arc({{0, -5}, {0, 0}}));
  int pieces = 0;
  while (walk.advance()) {
    ++pieces;
    EXPECT_EQ(walk.a(), 0);
    EXPECT_EQ(walk.b(), 5);
    walk.move(walk.left_a(), walk.left_b());
  }
  EXPECT_EQ(pieces, 4);
}

TEST(ArcWalk, RoundsRootsExactly) {
  for (std::int64_t v = 0; v < 3000; ++v)
    ASSERT_EQ(interpolation::rounded_root(v),
              std::lround(std::sqrt(static_cast<double>(v))));
  constexpr std::int64_t kBig = std::int64_t{1} << 30;
  EXPECT_EQ(interpolation::rounded_root(2 * kBig * kBig - 1), 1518500250);
  EXPECT_EQ(interpolation::rounded_root(kBig * kBig), kBig);
}

TEST(Increments, TakeAboutLengthOverPathPeriods) {
  InterpolatorOptions options;
  options.feed = 250;
  options.period = 0.2;
  const Segment s{3000, -4000};
  const auto run = Interpolator::line(Method::increments, s, options);
  ASSERT_TRUE(run);
  const Trace t = oracle::follow_line(*run, s);
  EXPECT_NEAR(static_cast<double>(t.ticks), 100, 1);
  const Arc arc{{-1000, 0}, {0, 0}};
  const Trace c =
      oracle::follow_arc(arc_of(Method::increments, arc, options), arc);
  EXPECT_NEAR(static_cast<double>(c.ticks), 2000 * 3.14159265 / 50, 4);
}

TEST(Increments, StayWithinOneUnitForAnyFirstStep) {
  for (std::int32_t h = 1; h <= 256; h *= 2) {
    InterpolatorOptions options;
    options.feed = 500;
    options.first_step = h;
    for (const Segment s : {Segment{100'000, 3},
                            {77'777, 55'555},
                            {-5, 60'000},
                            {40'000, -40'001}}) {
      const auto run = Interpolator::line(Method::increments, s, options);
      ASSERT_TRUE(run);
      EXPECT_LE(oracle::follow_line(*run, s).worst, 1.0L) << h;
    }
    const Arc arc{{12'345, -6'789}, {0, 0}};
    EXPECT_LE(
        oracle::follow_arc(arc_of(Method::increments, arc, options), arc).worst,
        1.0L)
        << h;
  }
}

TEST(Increments, RefuseOptionsOutOfRange) {
  InterpolatorOptions options;
  options.first_step = 3;
  EXPECT_FALSE(Interpolator::line(Method::increments, {9, 9}, options));
  for (const double feed : {0.0, -1.0, 1e-9, 1e12, std::nan("")}) {
    InterpolatorOptions bad;
    bad.feed = feed;
    for (const Method m : {Method::increments, Method::general}) {
      const auto run = Interpolator::line(m, {9, 9}, bad);
      ASSERT_FALSE(run);
      EXPECT_EQ(run.error().code, ErrorCode::out_of_range);
    }
  }
}

TEST(General, GivesTheSamePathFromAnySineSource) {
  const Arc arc{{1234, -567}, {0, 0}, false};
  for (const SineSource source :
       {SineSource::cordic, SineSource::meggitt, SineSource::rom}) {
    InterpolatorOptions options;
    options.source = source;
    options.feed = 20;
    const Trace t =
        oracle::follow_arc(arc_of(Method::general, arc, options), arc);
    EXPECT_LE(t.worst, 0.75L);
    const double circle = 2 * 3.14159265 * std::hypot(1234, 567);
    EXPECT_NEAR(static_cast<double>(t.ticks), circle / 20, 1);
  }
}

}  // namespace
}  // namespace unstep
