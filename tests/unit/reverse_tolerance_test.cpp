#include <gtest/gtest.h>

#include <string>

#include "unit/frechet_oracle.h"
#include "unit/reverse_tolerance_chains.h"
#include "unstep/formats.h"
#include "unstep/reverse.h"

namespace unstep {
namespace {

using namespace testing;

const std::vector<Rational> kTolerances{{1, 2}, {3, 4}, {1, 1}, {3, 2},
                                        {2, 1}, {4, 1}, {10, 1}};

long double value(const Rational& e) {
  return static_cast<long double>(e.numerator) / e.denominator;
}

std::string text(const Chain& chain, const Rational& e) {
  std::string result = std::to_string(e.numerator) + "/" +
                       std::to_string(e.denominator) +
                       (chain.closed ? " closed " : " open ");
  for (std::size_t i = 0; i < std::min<std::size_t>(chain.steps.size(), 400);
       ++i) {
    result += static_cast<char>('0' + chain.steps[i]);
  }
  return result;
}

/// What holds for every path, whatever the effort.
void expect_sound(const Chain& chain, const Rational& e, Effort effort) {
  ToleranceOptions options;
  options.tolerance = e;
  options.effort = effort;
  options.arcs = false;
  const auto path = reverse_tolerance(chain, YAxis::down, options);
  ASSERT_TRUE(path) << path.error().message << ' ' << text(chain, e);
  const std::int32_t scale = path_scale(e);
  EXPECT_EQ(path->closed, chain.closed);
  const Polyline points = polyline_of(chain, YAxis::down);
  const Polyline lines = polyline_of(*path, scale);
  if (!chain.closed) {
    EXPECT_EQ(lines.front().x, points.front().x);
    EXPECT_EQ(lines.front().y, points.front().y);
    EXPECT_EQ(lines.back().x, points.back().x);
    EXPECT_EQ(lines.back().y, points.back().y);
  } else {
    EXPECT_EQ(lines.front().x, lines.back().x);
    EXPECT_EQ(lines.front().y, lines.back().y);
  }
  for (const Path::Element& element : path->elements) {
    EXPECT_TRUE(element.segment.dx != 0 || element.segment.dy != 0);
  }
  EXPECT_TRUE(path_within(chain, YAxis::down, *path, scale, value(e)))
      << text(chain, e);
}

void expect_sound(const Chain& chain) {
  for (const Rational& e : kTolerances) {
    expect_sound(chain, e, Effort::standard);
    expect_sound(chain, e, Effort::max);
  }
}

std::size_t segments(const Chain& chain, const Rational& e,
                     Effort effort = Effort::standard) {
  ToleranceOptions options;
  options.tolerance = e;
  options.effort = effort;
  options.arcs = false;
  return reverse_tolerance(chain, YAxis::down, options)->elements.size();
}

TEST(FrechetOracle, MeasuresTheSegmentAndTheOrder) {
  const Polyline bump{{0, 0}, {4, 2}, {8, 0}};
  EXPECT_TRUE(frechet_within(bump, {{0, 0}, {8, 0}}, 2));
  EXPECT_FALSE(frechet_within(bump, {{0, 0}, {8, 0}}, 1.99L));
  // Near the line, but far from the segment.
  EXPECT_FALSE(frechet_within({{0, 0}, {9, 0}, {5, 0}}, {{0, 0}, {5, 0}}, 3));
  // Near the segment, but back and forth: 4 back need 2.
  const Polyline back{{0, 0}, {6, 0}, {2, 0}, {8, 0}};
  EXPECT_TRUE(frechet_within(back, {{0, 0}, {8, 0}}, 2));
  EXPECT_FALSE(frechet_within(back, {{0, 0}, {8, 0}}, 1.9L));
}

TEST(ReverseTolerance, KeepsTheBoundOnRandomChains) {
  std::mt19937 random(1);
  for (int run = 0; run < 60; ++run) {
    const std::uint32_t turning = 1 + static_cast<std::uint32_t>(random() % 12);
    expect_sound(random_chain(random, 1 + random() % 150, turning));
  }
}

TEST(ReverseTolerance, KeepsTheBoundOnRetracedChains) {
  std::mt19937 random(2);
  for (int run = 0; run < 40; ++run) {
    const std::uint32_t turning = 1 + static_cast<std::uint32_t>(random() % 20);
    const Chain there = random_chain(random, 1 + random() % 80, turning);
    Chain chain = retraced(there);
    expect_sound(chain);
    chain.closed = false;
    expect_sound(chain);
  }
}

TEST(ReverseTolerance, KeepsTheBoundOnContours) {
  std::mt19937 random(3);
  for (const std::uint32_t sticking : {0U, 120U, 200U, 240U}) {
    for (const Chain& contour : contours_of(blots(random, 24, sticking))) {
      expect_sound(contour);
    }
  }
  for (const std::int32_t radius : {1, 2, 3, 5, 9, 20, 41}) {
    for (const Chain& contour : contours_of(disc(radius, radius - 1))) {
      expect_sound(contour);
    }
  }
}

TEST(ReverseTolerance, KeepsTheBoundOnTheContoursOfTheSamples) {
  for (const char* name : {"glyph.pbm", "crown.png"}) {
    const auto bytes = read_file(
        std::string(UNSTEP_SOURCE_DIR) + "/samples/" + name, 1U << 24);
    ASSERT_TRUE(bytes);
    auto file = RasterReader::open(*bytes, {});
    ASSERT_TRUE(file);
    for (const Chain& contour : contours_of(file->read(0)->ink)) {
      for (const Rational& e : kTolerances) {
        expect_sound(contour, e, Effort::standard);
      }
    }
  }
}

TEST(ReverseTolerance, ChainsWithoutStepsAreTheirOrigin) {
  for (const bool closed : {false, true}) {
    Chain chain = open_chain({}, {3, -4});
    chain.closed = closed;
    const auto path = reverse_tolerance(chain, YAxis::up, {});
    ASSERT_TRUE(path);
    EXPECT_EQ(path->origin, (Point{3, -4}));
    EXPECT_EQ(path->closed, closed);
    EXPECT_TRUE(path->elements.empty());
  }
}

TEST(ReverseTolerance, OneStepIsOneLineInEachDirectionAndAxis) {
  for (Step step = 0; step < 8; ++step) {
    for (const YAxis axis : {YAxis::up, YAxis::down}) {
      const auto path = reverse_tolerance(open_chain({step}), axis, {});
      ASSERT_TRUE(path);
      ASSERT_EQ(path->elements.size(), 1U);
      const Point delta = step_delta(step, axis);
      EXPECT_EQ(path->elements[0].segment, (Segment{delta.x, delta.y}));
    }
  }
}

TEST(ReverseTolerance, ALongRunIsOneLine) {
  for (Step step = 0; step < 8; ++step) {
    const Chain chain = open_chain(std::vector<Step>(100000, step));
    for (const Rational& e : kTolerances) EXPECT_EQ(segments(chain, e), 1U);
  }
}

TEST(ReverseTolerance, BumpsOfExactlyTheToleranceAreFlattened) {
  // North, east, ..., south and the same below: one unit off on both sides.
  std::vector<Step> steps;
  const auto run = [&](Step step, int count) {
    steps.insert(steps.end(), static_cast<std::size_t>(count), step);
  };
  run(0, 20), run(2, 1), run(0, 9), run(6, 2), run(0, 9), run(2, 1);
  run(0, 20);
  EXPECT_EQ(segments(open_chain(steps), {1, 1}), 1U);
  EXPECT_GT(segments(open_chain(steps), {9, 10}), 1U);
}

TEST(ReverseTolerance, ASquareStaysASquare) {
  Bitmap ink = *Bitmap::create(40, 40);
  for (std::int32_t y = 5; y < 35; ++y) {
    for (std::int32_t x = 5; x < 35; ++x) ink.set(x, y, true);
  }
  for (const Rational& e : kTolerances) {
    EXPECT_LE(segments(contours_of(ink)[0], e), 5U);
    EXPECT_EQ(segments(contours_of(ink)[0], e, Effort::max), 4U);
  }
}

TEST(ReverseTolerance, RingsOfInkKeepAnInside) {
  // A pixel at a tolerance that would let it collapse to a line.
  Bitmap ink = *Bitmap::create(3, 3);
  ink.set(1, 1, true);
  const Chain pixel = contours_of(ink)[0];
  for (const Rational& e : kTolerances) {
    EXPECT_EQ(segments(pixel, e), 4U);
    EXPECT_EQ(segments(pixel, e, Effort::max), 4U);
  }
  expect_sound(pixel);
}

TEST(ReverseTolerance, AHugeToleranceLeavesLittle) {
  std::mt19937 random(4);
  const Rational huge{1U << 20, 1};
  const Chain walk = random_chain(random, 5000, 3);
  expect_sound(walk, huge, Effort::standard);
  EXPECT_EQ(segments(walk, huge), 1U);
  const Chain back = retraced(walk);
  expect_sound(back, huge, Effort::standard);
  EXPECT_LE(segments(back, huge), 4U);
}

TEST(ReverseTolerance, SpiralsKeepTheBound) {
  std::vector<Step> steps;
  for (std::size_t turn = 0; turn < 60; ++turn) {
    steps.insert(steps.end(), 1 + turn / 2, static_cast<Step>(turn * 2 % 8));
  }
  expect_sound(open_chain(steps));
  expect_sound(retraced(open_chain(steps)));
}

TEST(ReverseTolerance, WorksAtTheEndsOfTheCoordinateRange) {
  for (const std::int32_t x : {-kMaxCoord, kMaxCoord}) {
    const Step in = x < 0 ? 0 : 4;
    std::vector<Step> steps;
    for (int i = 0; i < 300; ++i) {
      steps.push_back(in);
      if (i % 3 == 0) steps.push_back(2);
    }
    const Chain chain = open_chain(steps, {x, -kMaxCoord});
    const auto path = reverse_tolerance(chain, YAxis::up, {});
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_LE(path->elements.size(), 2U);
    EXPECT_TRUE(path_within(chain, YAxis::up, *path, 1, 1));
    // On a sub-grid the same coordinates do not fit.
    ToleranceOptions half;
    half.tolerance = {1, 2};
    const auto none = reverse_tolerance(chain, YAxis::up, half);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::invalid_argument);
  }
}

TEST(ReverseTolerance, LinesLongerThanTheFastArithmeticAreRight) {
  // Slope 1/7 with a step aside every 1000: beyond 2^9 and 2^18 units.
  std::vector<Step> steps;
  for (int i = 0; i < 700000; ++i) {
    steps.push_back(i % 7 == 3 ? 1 : 0);
    if (i % 1000 == 0) steps.push_back(i % 2000 == 0 ? 2 : 6);
  }
  const Chain chain = open_chain(steps);
  for (const Rational& e : {Rational{2, 1}, Rational{1000, 1}}) {
    const auto path = reverse_tolerance(chain, YAxis::up, {.tolerance = e});
    ASSERT_TRUE(path);
    EXPECT_LE(path->elements.size(), 3U);
    EXPECT_TRUE(path_within(chain, YAxis::up, *path, 1, value(e)));
  }
}

TEST(ReverseTolerance, TimeIsLinearWhenNoPointBeyondFits) {
  // A step aside and then straight on, one unit off for ever.
  std::vector<Step> steps;
  for (int i = 0; i < 200; ++i) {
    steps.insert(steps.end(), 2000, 0);
    steps.insert(steps.end(), {2, 2, 2});
    steps.insert(steps.end(), 2000, 4);
    steps.insert(steps.end(), {2, 2, 2});
  }
  EXPECT_LE(segments(open_chain(steps), {1, 1}), 801U);
}

TEST(ReverseTolerance, SubGridIsAPowerOfTwoBelowOne) {
  EXPECT_EQ(path_scale({1, 1}), 1);
  EXPECT_EQ(path_scale({7, 2}), 1);
  for (const Rational& e : {Rational{999, 1000}, Rational{1, 2}, Rational{1, 3},
                            Rational{1, 256}}) {
    const std::int32_t scale = path_scale(e);
    EXPECT_EQ(scale & (scale - 1), 0);
    EXPECT_GE(scale, 2);
    EXPECT_LE(scale, Drawing::kMaxScale);
  }
}

TEST(ReverseTolerance, RefusesWhatIsNoChainOrNoTolerance) {
  ToleranceOptions options;
  for (const Rational& e : {Rational{0, 1}, Rational{1, 0}, Rational{1, 257},
                            Rational{(1U << 20) + 1, 1}}) {
    options.tolerance = e;
    const auto path = reverse_tolerance(open_chain({0}), YAxis::up, options);
    ASSERT_FALSE(path);
    EXPECT_EQ(path.error().code, ErrorCode::out_of_range);
  }
  std::vector<Chain> bad{open_chain({0, 9}), open_chain({4}, {-kMaxCoord, 0})};
  bad.push_back({{}, Connectivity::four, false, {1}});
  bad.push_back({{}, Connectivity::four, true, {0}});
  bad.push_back(open_chain({0}, {kMaxCoord, 0}));
  for (const Chain& chain : bad) {
    const auto path = reverse_tolerance(chain, YAxis::up, {});
    ASSERT_FALSE(path);
    EXPECT_EQ(path.error().code, ErrorCode::invalid_argument);
  }
  Drawing drawing;
  drawing.paths.emplace_back();
  EXPECT_EQ(reverse_tolerance(drawing, {}).error().code,
            ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace unstep
