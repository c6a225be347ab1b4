#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "reverse/line_price.h"
#include "reverse/tolerance_cheap.h"
#include "unit/reverse_tolerance_chains.h"
#include "unstep/codec.h"
#include "unstep/deviation.h"
#include "unstep/reverse.h"

namespace unstep::reverse {
namespace {

using namespace testing;

Drawing contours_in(const Bitmap& ink) {
  Drawing drawing;
  drawing.canvas = {ink.width(), ink.height(), YAxis::down};
  drawing.chains = contours_of(ink);
  return drawing;
}

Drawing cheap(const Drawing& chains, Rational tolerance, Effort effort) {
  ToleranceOptions options;
  options.tolerance = tolerance;
  options.effort = effort;
  options.aim = LineAim::few_bytes;
  return *reverse_tolerance(chains, options);
}

std::size_t bytes_of(const Drawing& paths) {
  UstpWriter writer({});
  (void)writer.add_page(paths, {}, {Fidelity::Kind::tolerance, {1, 1}});
  return writer.finish()->size();
}

TEST(CheapLines, KeepTheBoundOnBlotsAtEveryTolerance) {
  std::mt19937 random(41);
  for (const std::uint32_t sticking : {120U, 200U, 240U}) {
    const Drawing chains = contours_in(blots(random, 48, sticking));
    for (const Rational e :
         {Rational{1, 2}, {3, 4}, {1, 1}, {3, 2}, {2, 1}, {5, 1}}) {
      const Drawing paths = cheap(chains, e, Effort::standard);
      const Status within = check_deviation(chains, paths, e);
      EXPECT_TRUE(within) << within.error().message << " e " << e.numerator
                          << "/" << e.denominator;
    }
  }
}

TEST(CheapLines, KeepTheBoundOnOpenAndRetracedChains) {
  std::mt19937 random(42);
  Drawing chains;
  for (int i = 0; i < 40; ++i) {
    chains.chains.push_back(random_chain(random, 100, 4));
    chains.chains.push_back(retraced(random_chain(random, 40, 6)));
  }
  chains.chains.push_back(open_chain({}));
  chains.chains.push_back(open_chain({3}));
  chains.chains.push_back(open_chain(std::vector<Step>(5000, 1)));
  for (const Effort effort : {Effort::standard, Effort::max}) {
    const Drawing paths = cheap(chains, {1, 1}, effort);
    const Status within = check_deviation(chains, paths, {1, 1});
    EXPECT_TRUE(within) << within.error().message;
  }
}

TEST(CheapLines, CostFewerBytesThanFewLines) {
  std::mt19937 random(43);
  const Drawing chains = contours_in(blots(random, 256, 236));
  ToleranceOptions few;
  few.arcs = false;
  const std::size_t lines = bytes_of(*reverse_tolerance(chains, few));
  const std::size_t bytes = bytes_of(cheap(chains, {1, 1}, Effort::standard));
  EXPECT_LT(bytes * 100, lines * 96) << bytes << " / " << lines;
}

TEST(CheapLines, StartRingsAtTheirTopmostVertex) {
  const Drawing chains = contours_in(disc(60, 30));
  CheapSearch search({4096});
  for (const Chain& chain : chains.chains) {
    const ChainWalk walk(chain, YAxis::down, 1);
    const LineVertices ring =
        fit_cheap_lines(search, walk, {4096}, LinePrice(), 2);
    const Point start = ring.front().at;
    for (const LineVertex& vertex : ring) {
      EXPECT_TRUE(vertex.at.y > start.y ||
                  (vertex.at.y == start.y && vertex.at.x >= start.x));
    }
    EXPECT_EQ(ring.back().index, ring.front().index + chain.steps.size());
  }
}

TEST(CheapLines, GoOnFromWindowToWindow) {
  std::mt19937 random(44);
  Drawing chains;
  chains.chains.push_back(random_chain(random, 5 * kCheapWindow, 3));
  chains.chains.push_back(retraced(random_chain(random, 2 * kCheapWindow, 3)));
  const Drawing paths = cheap(chains, {2, 1}, Effort::standard);
  const Status within = check_deviation(chains, paths, {2, 1});
  EXPECT_TRUE(within) << within.error().message;
}

TEST(LinePrice, OfLinesThatWereSeenFalls) {
  LinePrice price;
  const LineVertices path{{0, {0, 0}}, {1, {7, 3}}, {2, {14, 9}}};
  const auto now = [&] { return price(price.after({7, 3}), 7, 6); };
  const std::int32_t before = now();
  for (int i = 0; i < 1000; ++i) price.count(path, false);
  price.settle();
  EXPECT_LT(now(), before);
  EXPECT_GT(now(), 0);
}

TEST(LinePrice, OfLinesNearbyIsNotBelowTheLeast) {
  const LinePrice price;
  std::mt19937 random(44);
  std::uniform_int_distribution<std::int32_t> any(-60, 60);
  for (int i = 0; i < 3000; ++i) {
    const LinePrice::Context context = price.after({any(random), any(random)});
    const Point line{any(random), any(random)};
    const std::int32_t near = std::max(std::abs(line.x), std::abs(line.y)) / 4;
    if (near == 0) continue;
    const std::int32_t least = price.least(context, line.x, line.y);
    for (const std::int32_t y : {-near, 0, near}) {
      for (const std::int32_t x : {-near, 0, near}) {
        EXPECT_GE(price(context, line.x + x, line.y + y), least)
            << line.x << " " << line.y << " " << x << " " << y;
      }
    }
  }
}

TEST(LinePrice, HoldsAtTheLimitOfCoordinates) {
  const LinePrice price;
  constexpr std::int32_t kFar = 2'000'000'000;
  EXPECT_GT(price(price.after({-kFar, kFar}), kFar, 1 - kFar),
            30 * LinePrice::kBit);
  EXPECT_GT(price(price.after({}), -kFar, 0), 10 * LinePrice::kBit);
}

}  // namespace
}  // namespace unstep::reverse
