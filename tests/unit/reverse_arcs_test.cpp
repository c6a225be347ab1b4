#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "common/frechet_samples.h"
#include "unstep/bitmap.h"
#include "unstep/deviation.h"
#include "unstep/reverse.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

/// The closed 8-connected chain of the grid points nearest to a curve given by
/// its places from 0 to 1.
template <class Curve>
Chain digitised(const Curve& curve, double length) {
  Chain chain;
  chain.closed = true;
  const auto parts = static_cast<int>(length * 4) + 8;
  Point at{};
  for (int i = 0; i <= parts; ++i) {
    const auto [x, y] = curve(static_cast<double>(i % parts) / parts);
    const Point to{static_cast<std::int32_t>(std::lround(x)),
                   static_cast<std::int32_t>(std::lround(y))};
    if (i == 0) chain.origin = at = to;
    for (Step step = 0; step < 8 && at != to; ++step) {
      const Point d = step_delta(step);
      if (at.x + d.x != to.x || at.y + d.y != to.y) continue;
      chain.steps.push_back(step);
      at = to;
    }
    EXPECT_EQ(at, to);
  }
  return chain;
}

Chain ellipse(double cx, double cy, double a, double b) {
  return digitised(
      [=](double t) {
        const double angle = 2 * std::numbers::pi * t;
        return std::pair(cx + a * std::cos(angle), cy + b * std::sin(angle));
      },
      7 * std::max(a, b));
}

/// The contour of a disc's pixels: 4-connected.
Chain disc_contour(int side, double cx, double cy, double radius) {
  Bitmap ink = *Bitmap::create(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if (std::hypot(x + 0.5 - cx, y + 0.5 - cy) <= radius) ink.set(x, y, true);
  Chain found;
  EXPECT_TRUE(trace_contours(ink, [&](const Chain& chain) {
    found = chain;
    return true;
  }));
  return found;
}

Drawing drawing_of(Chain chain, YAxis axis = YAxis::up) {
  Drawing drawing;
  drawing.canvas.y_axis = axis;
  drawing.chains.push_back(std::move(chain));
  return drawing;
}

/// Fits, proves by both forms of the checker, returns the path.
Path fitted(const Drawing& drawing, Rational tolerance, bool measure = true) {
  ToleranceOptions options;
  options.tolerance = tolerance;
  const Result<Drawing> made = reverse_tolerance(drawing, options);
  EXPECT_TRUE(made) << made.error().message;
  if (!made) return {};
  const Status within = check_deviation(drawing, *made, tolerance);
  EXPECT_TRUE(within) << within.error().message;
  if (measure) {
    const Result<Deviation> found = measure_deviation(drawing, *made);
    EXPECT_TRUE(found);
    const double most = static_cast<double>(tolerance.numerator) /
                        static_cast<double>(tolerance.denominator);
    EXPECT_LE(found ? found->distance : 1e9, most + 1.0 / 1024);
  }
  return made->paths.at(0);
}

std::size_t arcs_of(const Path& path) {
  std::size_t arcs = 0;
  for (const Path::Element& element : path.elements)
    arcs += element.kind == Path::Kind::arc ? 1 : 0;
  return arcs;
}

TEST(ReverseArcs, ADigitisedCircleIsOneFullCircle) {
  for (const int radius : {5, 6, 7, 10, 23, 64, 100, 301, 1000, 5000}) {
    SCOPED_TRACE(radius);
    const Path path = fitted(drawing_of(ellipse(3, -4, radius, radius)), {1, 1},
                             radius <= 301);
    ASSERT_EQ(path.elements.size(), 1U);
    EXPECT_EQ(path.elements[0].arc.end, Point{});
    EXPECT_EQ(path.origin.x + path.elements[0].arc.centre.x, 3);
    EXPECT_EQ(path.origin.y + path.elements[0].arc.centre.y, -4);
    EXPECT_FALSE(path.elements[0].arc.clockwise);
  }
}

TEST(ReverseArcs, ACircleOfTenThousandIsAtMostThreeArcsWhereverItsCentre) {
  std::mt19937 random(7);
  for (int i = 0; i < 4; ++i) {
    const double x = static_cast<double>(random() % 1000) / 1000;
    const double y = static_cast<double>(random() % 1000) / 1000;
    const double radius = 10000 + static_cast<double>(random() % 1000) / 1000;
    SCOPED_TRACE(std::to_string(x) + " " + std::to_string(y));
    const Path path =
        fitted(drawing_of(ellipse(x, y, radius, radius)), {1, 1}, false);
    EXPECT_LE(path.elements.size(), 3U);
    EXPECT_EQ(arcs_of(path), path.elements.size());
  }
}

TEST(ReverseArcs, CirclesOfEveryKindKeepTheBound) {
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    const double radius = 1 + std::pow(10.0, static_cast<double>(i % 30) / 12);
    const double x = static_cast<double>(random() % 997) / 997;
    const double y = static_cast<double>(random() % 997) / 997;
    SCOPED_TRACE(std::to_string(radius) + " at " + std::to_string(x) + " " +
                 std::to_string(y));
    const Rational e{i % 3 == 0 ? 3U : 2U, i % 4 == 0 ? 4U : 2U};
    const Path path = fitted(drawing_of(ellipse(x, y, radius, radius)), e);
    const bool smooth = radius > 20 && e.numerator >= e.denominator;
    EXPECT_LE(path.elements.size(), smooth ? 4U : 1000U);
  }
  // Larger ones, by the exact form alone.
  for (const double radius : {3000.4, 7777.7, 20000.5}) {
    SCOPED_TRACE(radius);
    const Path path =
        fitted(drawing_of(ellipse(0.3, 0.6, radius, radius)), {1, 1}, false);
    EXPECT_LE(path.elements.size(), 3U);
  }
}

TEST(ReverseArcs, TheContourOfADiscIsAFewArcs) {
  for (const double radius : {8.0, 20.5, 61.3}) {
    for (const double off : {0.0, 0.25, 0.5}) {
      SCOPED_TRACE(std::to_string(radius) + " " + std::to_string(off));
      const Chain chain = disc_contour(140, 70 + off, 70 - off, radius);
      const Path path = fitted(drawing_of(chain, YAxis::down), {1, 1});
      EXPECT_LE(path.elements.size(), 4U);
      EXPECT_GE(arcs_of(path), 1U);
    }
  }
}

TEST(ReverseArcs, EllipsesAndRoundedRectanglesKeepTheBound) {
  for (const double b : {12.0, 31.5, 80.0, 140.25}) {
    const Path path = fitted(drawing_of(ellipse(0.5, 0.1, 150, b)), {1, 1});
    EXPECT_GE(arcs_of(path), 1U) << b;
  }
  // A rectangle of 200 x 100 with corners of radius 30.
  const auto rounded = [](double t) {
    const double s = t * (2 * 140 + 2 * 40 + 60 * std::numbers::pi);
    constexpr double kQuarter = 15 * std::numbers::pi;
    const auto corner = [](double cx, double cy, double from, double along) {
      const double angle = from + along / 30;
      return std::pair(cx + 30 * std::cos(angle), cy + 30 * std::sin(angle));
    };
    double at = s;
    if (at < 140) return std::pair(30 + at, 0.0);
    at -= 140;
    if (at < kQuarter) return corner(170, 30, -std::numbers::pi / 2, at);
    at -= kQuarter;
    if (at < 40) return std::pair(200.0, 30 + at);
    at -= 40;
    if (at < kQuarter) return corner(170, 70, 0, at);
    at -= kQuarter;
    if (at < 140) return std::pair(170 - at, 100.0);
    at -= 140;
    if (at < kQuarter) return corner(30, 70, std::numbers::pi / 2, at);
    at -= kQuarter;
    if (at < 40) return std::pair(0.0, 70 - at);
    return corner(30, 30, std::numbers::pi, at - 40);
  };
  const Path path = fitted(drawing_of(digitised(rounded, 560)), {1, 1});
  EXPECT_LE(path.elements.size(), 9U);
  EXPECT_GE(arcs_of(path), 4U);
}

TEST(ReverseArcs, AgreeWithBruteForceOnRandomChains) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Chain chain;
    double angle = 0;
    double turn = 0.05;
    double x = 0;
    double y = 0;
    Point at{};
    while (chain.steps.size() < 110) {
      if (random() % 40 == 0)
        turn = (static_cast<double>(random() % 21) - 10) / 60;
      angle += turn;
      x += std::cos(angle);
      y += std::sin(angle);
      const Point to{static_cast<std::int32_t>(std::lround(x)),
                     static_cast<std::int32_t>(std::lround(y))};
      for (Step step = 0; step < 8; ++step) {
        const Point d = step_delta(step);
        if (at.x + d.x == to.x && at.y + d.y == to.y)
          chain.steps.push_back(step);
      }
      at = to;
    }
    const Rational e{1 + seed % 4, seed % 3 + 1};
    const double bound = static_cast<double>(e.numerator) / e.denominator;
    ToleranceOptions options;
    options.tolerance = e;
    const Drawing drawing = drawing_of(chain);
    const Result<Drawing> made = reverse_tolerance(drawing, options);
    ASSERT_TRUE(made);
    EXPECT_TRUE(check_deviation(drawing, *made, e));
    constexpr long double kSpacing = 0.2L;
    const auto oracle = testing::discrete_frechet(
        testing::samples_of(chain, YAxis::up, kSpacing),
        testing::samples_of(made->paths[0], made->scale, kSpacing));
    EXPECT_LE(static_cast<double>(oracle), bound + 2 * 0.2);
  }
}

TEST(ReverseArcs, AreOffWhenNotWanted) {
  ToleranceOptions options;
  options.arcs = false;
  ToleranceReport report;
  const Drawing drawing = drawing_of(ellipse(0, 0, 100, 100));
  const Result<Drawing> made = reverse_tolerance(drawing, options, &report);
  ASSERT_TRUE(made);
  EXPECT_EQ(arcs_of(made->paths[0]), 0U);
  EXPECT_EQ(report.arcs, 0U);
  EXPECT_EQ(report.segments, made->paths[0].elements.size());
  options.arcs = true;
  ASSERT_TRUE(reverse_tolerance(drawing, options, &report));
  EXPECT_EQ(report.arcs, 1U);
  EXPECT_EQ(report.segments, 0U);
}

/// Turns of the polyline about a place: a crossing of two rings that were one
/// inside the other would be seen as samples of one on both sides of the other.
bool inside(const testing::Samples& ring, const testing::Sample& p) {
  bool in = false;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const auto& [ax, ay] = ring[i - 1];
    const auto& [bx, by] = ring[i];
    if ((ay > p.second) == (by > p.second)) continue;
    if (p.first < ax + (p.second - ay) / (by - ay) * (bx - ax)) in = !in;
  }
  return in;
}

TEST(ReverseArcs, ThinRingsDoNotCrossAtAToleranceOfOne) {
  std::mt19937 random(11);
  for (int i = 0; i < 24; ++i) {
    SCOPED_TRACE(i);
    const double x = 60 + static_cast<double>(random() % 100) / 100;
    const double y = 60 + static_cast<double>(random() % 100) / 100;
    const double radius = 14 + static_cast<double>(random() % 400) / 10;
    const double width = 1.2 + static_cast<double>(random() % 20) / 10;
    Bitmap ink = *Bitmap::create(120, 120);
    for (int row = 0; row < 120; ++row)
      for (int column = 0; column < 120; ++column)
        if (std::abs(std::hypot(column + 0.5 - x, row + 0.5 - y) - radius) <=
            width / 2)
          ink.set(column, row, true);
    Drawing drawing;
    drawing.canvas.y_axis = YAxis::down;
    ASSERT_TRUE(trace_contours(ink, [&](const Chain& chain) {
      drawing.chains.push_back(chain);
      return true;
    }));
    if (drawing.chains.size() != 2) continue;
    const Result<Drawing> made = reverse_tolerance(drawing, {});
    ASSERT_TRUE(made);
    EXPECT_TRUE(check_deviation(drawing, *made, {1, 1}));
    const auto outer = testing::samples_of(made->paths[0], 1, 0.05L);
    const auto inner = testing::samples_of(made->paths[1], 1, 0.05L);
    std::size_t out = 0;
    for (const auto& p : inner)
      if (!inside(outer, p)) ++out;
    EXPECT_EQ(out, 0U) << inner.size();
  }
}

}  // namespace
}  // namespace unstep
