#include "unstep/deviation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "common/frechet_samples.h"

namespace unstep {
namespace {

using testing::discrete_frechet;
using testing::discrete_frechet_closed;
using testing::samples_of;

constexpr double kFound = 1.0 / 2048;  // of measure_deviation

Chain chain_of(std::string_view codes, bool closed = false,
               Point origin = {0, 0}) {
  Chain chain;
  chain.origin = origin;
  chain.closed = closed;
  for (const char c : codes) chain.steps.push_back(static_cast<Step>(c - '0'));
  return chain;
}

Path::Element line(std::int32_t dx, std::int32_t dy) {
  return {Path::Kind::segment, {dx, dy}, {}};
}

Path::Element arc(Point centre, Point end, bool clockwise) {
  return {Path::Kind::arc, {}, {centre, end, clockwise}};
}

struct Pair {
  Drawing chains;
  Drawing paths;

  Pair(const Chain& chain, const Path& path, std::int32_t scale = 1) {
    chains.canvas.y_axis = YAxis::up;
    chains.chains = {chain};
    paths.paths = {path};
    paths.scale = scale;
  }

  [[nodiscard]] double measured() const {
    const Result<Deviation> found = measure_deviation(chains, paths);
    EXPECT_TRUE(found) << found.error().message;
    return found ? found->distance : -1;
  }
  [[nodiscard]] bool within(Rational tolerance) const {
    const Status status = check_deviation(chains, paths, tolerance);
    EXPECT_TRUE(status || status.error().code == ErrorCode::corrupt);
    return static_cast<bool>(status);
  }
  [[nodiscard]] bool within(double tolerance) const {
    return within(Rational{
        static_cast<std::uint32_t>(std::floor(tolerance * 4096)), 4096});
  }
};

TEST(Deviation, IsZeroForThePathThroughEveryCorner) {
  const Pair pair(chain_of("000222444"),
                  {{0, 0}, false, 0, {line(3, 0), line(0, 3), line(-3, 0)}});
  EXPECT_EQ(pair.measured(), 0);
  EXPECT_TRUE(pair.within(Rational{0, 1}));
  EXPECT_TRUE(pair.within(Rational{1, 256}));
}

TEST(Deviation, OfAStairFromItsLineIsExact) {
  // (1, 0) is 1 / sqrt(2) from the diagonal: 0.70710678...
  const Pair pair(chain_of("0202"), {{0, 0}, false, 0, {line(2, 2)}});
  EXPECT_NEAR(pair.measured(), std::sqrt(0.5), kFound);
  EXPECT_GE(pair.measured(), std::sqrt(0.5));
  EXPECT_FALSE(pair.within(Rational{70710678, 100000000}));
  EXPECT_TRUE(pair.within(Rational{70710679, 100000000}));
}

TEST(Deviation, OfARetracedZigzagIsFarThoughEveryPointIsNear) {
  // 10 east, 10 back, 10 east again: the line covers all its points.
  const std::string east(10, '0');
  const std::string west(10, '4');
  const Pair pair(chain_of(east + west + east),
                  {{0, 0}, false, 0, {line(10, 0)}});
  EXPECT_NEAR(pair.measured(), 5, kFound);
  EXPECT_TRUE(pair.within(Rational{5, 1}));
  EXPECT_FALSE(pair.within(Rational{4999, 1000}));
  const Result<Distance> apart = measure_distance(pair.chains, pair.paths);
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->of_chains.distance, 0);
  EXPECT_EQ(apart->of_paths.distance, 0);
}

TEST(Deviation, NeedsTheOrderOfThePathToo) {
  const Pair pair(chain_of("0000000000"),
                  {{0, 0}, false, 0, {line(10, 0), line(-8, 0), line(8, 0)}});
  EXPECT_NEAR(pair.measured(), 4, kFound);
  EXPECT_TRUE(pair.within(Rational{4, 1}));
  EXPECT_FALSE(pair.within(Rational{3999, 1000}));
}

TEST(Deviation, OfOpenChainsKeepsBothEnds) {
  const Pair shorter(chain_of("00000"), {{0, 0}, false, 0, {line(4, 0)}});
  EXPECT_TRUE(shorter.within(Rational{1, 1}));
  EXPECT_FALSE(shorter.within(Rational{99, 100}));
  const Pair turned(chain_of("00000"), {{5, 0}, false, 0, {line(-5, 0)}});
  EXPECT_FALSE(turned.within(Rational{4, 1}));
  EXPECT_NEAR(turned.measured(), 5, kFound);
}

TEST(Deviation, OfAClosedPathMayStartAnywhere) {
  // A square of side 4 from its corner, its path from another and from a side.
  const Chain square = chain_of("0000222244446666", true);
  const Path corner{
      {4, 4}, true, 0, {line(-4, 0), line(0, -4), line(4, 0), line(0, 4)}};
  EXPECT_EQ(Pair(square, corner).measured(), 0);
  EXPECT_TRUE(Pair(square, corner).within(Rational{1, 256}));
  // From (4, 1.5), in halves: the start is no point of the chain.
  const Path side{
      {8, 3},
      true,
      0,
      {line(0, 5), line(-8, 0), line(0, -8), line(8, 0), line(0, 3)}};
  EXPECT_TRUE(Pair(square, side, 2).within(Rational{1, 256}));
  const Path reversed{
      {4, 4}, true, 0, {line(0, -4), line(-4, 0), line(0, 4), line(4, 0)}};
  EXPECT_FALSE(Pair(square, reversed).within(Rational{2, 1}));
}

TEST(Deviation, OfOnePointIsItsDistance) {
  const Pair point(chain_of(""), {{3, 4}, false, 0, {}});
  EXPECT_TRUE(point.within(Rational{5, 1}));
  EXPECT_FALSE(point.within(Rational{4999, 1000}));
  EXPECT_NEAR(point.measured(), 5, kFound);
  const Pair stands(chain_of("0"), {{0, 0}, false, 0, {line(0, 0)}});
  EXPECT_TRUE(stands.within(Rational{1, 1}));
  EXPECT_FALSE(stands.within(Rational{999, 1000}));
  const Pair walks(chain_of(""), {{0, 0}, false, 0, {line(3, 4)}});
  EXPECT_TRUE(walks.within(Rational{5, 1}));
  EXPECT_FALSE(walks.within(Rational{4999, 1000}));
}

TEST(Deviation, NamesThePathAndThePlace) {
  Drawing chains;
  Drawing paths;
  chains.chains = {chain_of("0000"), chain_of("00002222", false, {7, 7})};
  paths.paths = {{{0, 0}, false, 0, {line(4, 0)}},
                 {{7, 7}, false, 0, {line(4, -4)}}};
  const Result<Deviation> found = measure_deviation(chains, paths);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->path, 1U);
  EXPECT_NEAR(found->distance, std::sqrt(8), kFound);
  EXPECT_NEAR(found->x, 11, 1.5);
  EXPECT_NEAR(found->y, 7, 1.5);
  const Status status = check_deviation(chains, paths, {1, 1});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::corrupt);
  EXPECT_TRUE(status.error().message.starts_with("path 2: "))
      << status.error().message;
}

TEST(Deviation, RefusesWhatDoesNotBelongTogether) {
  const Path open{{0, 0}, false, 0, {line(1, 0)}};
  const Path closed{{0, 0}, true, 0, {line(1, 0), line(-1, 0)}};
  const Path torn{{0, 0}, true, 0, {line(1, 0)}};
  const Path dot{{0, 0}, true, 0, {arc({0, 0}, {0, 0}, true)}};
  const auto code = [](const Drawing& a, const Drawing& b) {
    const Status status = check_deviation(a, b, {1, 1});
    const Result<Deviation> found = measure_deviation(a, b);
    EXPECT_FALSE(found);
    return status ? ErrorCode::internal : status.error().code;
  };
  constexpr ErrorCode kInvalid = ErrorCode::invalid_argument;
  const Pair mixed(chain_of("0"), closed);
  EXPECT_EQ(code(mixed.chains, mixed.paths), kInvalid);
  const Pair half(chain_of("04", true), torn);
  EXPECT_EQ(code(half.chains, half.paths), kInvalid);
  const Pair half_chain(chain_of("0", true), closed);
  EXPECT_EQ(code(half_chain.chains, half_chain.paths), kInvalid);
  const Pair none(chain_of("04", true), dot);
  EXPECT_EQ(code(none.chains, none.paths), kInvalid);
  Pair fewer(chain_of("0"), open);
  fewer.paths.paths.clear();
  EXPECT_EQ(code(fewer.chains, fewer.paths), kInvalid);
  const Pair step(chain_of("8"), open);
  EXPECT_EQ(code(step.chains, step.paths), kInvalid);
  const Pair good(chain_of("0"), open);
  EXPECT_FALSE(check_deviation(good.chains, good.paths, {1, 0}));
}

TEST(Deviation, OfArcsIsDecidedAtTheEdgeOfTheRing) {
  // The square of side 2 r about a circle of radius r: its corners are
  // (sqrt(2) - 1) r outside, and nothing is farther.
  std::string square;
  for (const char code : {'2', '4', '6', '0'}) square += std::string(20, code);
  const Chain chain = chain_of(square, true, {10, -10});
  for (const bool full : {true, false}) {
    Path circle{{10, 0}, true, 0, {arc({-10, 0}, {0, 0}, false)}};
    if (!full)
      circle.elements = {arc({-10, 0}, {-20, 0}, false),
                         arc({10, 0}, {20, 0}, false)};
    const Pair pair(chain, circle);
    const double corner = 10 * (std::sqrt(2.0) - 1);
    EXPECT_NEAR(pair.measured(), corner, 2 * kFound);
    EXPECT_TRUE(pair.within(Rational{4142136, 1000000}));
    EXPECT_FALSE(pair.within(Rational{4142135, 1000000}));
    // The other way round is far.
    for (Path::Element& element : circle.elements) element.arc.clockwise = true;
    EXPECT_FALSE(Pair(chain, circle).within(Rational{9, 1}));
  }
}

TEST(Deviation, IsDecidedAtTheLimitsOfCoordinates) {
  // A long way east at the top, and a far point of a fine sub-grid.
  constexpr std::int32_t kFar = kMaxCoord - 100;
  const Chain chain = chain_of(std::string(100, '0') + std::string(3, '2'),
                               false, {kFar, -kMaxCoord});
  const Path near{{kFar, -kMaxCoord + 1}, false, 0, {line(100, 0), line(0, 2)}};
  EXPECT_TRUE(Pair(chain, near).within(Rational{1, 1}));
  EXPECT_FALSE(Pair(chain, near).within(Rational{999999, 1000000}));
  EXPECT_NEAR(Pair(chain, near).measured(), 1, kFound);
  // Elements as long as the whole range: wide integers.
  const Path across{{kFar, -kMaxCoord},
                    false,
                    0,
                    {line(-kMaxCoord, 0), line(kMaxCoord, 0), line(100, 3)}};
  EXPECT_FALSE(Pair(chain, across).within(Rational{1000000, 1}));
  const Chain fine = chain_of("01", false, {1000, -1000});
  const std::int32_t scale = Drawing::kMaxScale;
  const Path sub{{1000 * scale, -1000 * scale},
                 false,
                 0,
                 {line(scale + 1, 0), line(scale - 1, scale)}};
  EXPECT_TRUE(Pair(fine, sub, scale).within(Rational{1, 1 << 20}));
  EXPECT_FALSE(Pair(fine, sub, scale).within(Rational{1, 1 << 22}));
}

TEST(Deviation, TreatsHugeArcsByTheThoroughForm) {
  // A radius of 2^29 over 8 steps is a line but for 2^-26.
  const Path path{{0, 0}, false, 0, {arc({4, 1 << 29}, {8, 0}, false)}};
  const Pair pair(chain_of("00000000"), path);
  EXPECT_LE(pair.measured(), 0.001);
  EXPECT_TRUE(pair.within(Rational{1, 1000}));
}

TEST(Deviation, DistanceOfDrawingsNeedsNoPairs) {
  Drawing chains;
  Drawing paths;
  chains.chains = {chain_of("0000"), chain_of("2222", false, {50, 0})};
  paths.paths = {{{100, 2}, false, 0, {line(0, -20)}},
                 {{0, 6}, false, 0, {line(8, 0)}}};
  paths.scale = 2;
  const Result<Distance> found = measure_distance(chains, paths);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->of_chains.distance, 3, 0.125);
  // (50, -9) is 9 from (50, 0): y grows downwards, the chain goes to -4.
  EXPECT_NEAR(found->of_paths.distance, 5, 0.125);
  EXPECT_NEAR(found->of_paths.y, -9, 0.125);
  EXPECT_FALSE(measure_distance(chains, Drawing()));
  EXPECT_FALSE(measure_distance(chains, paths, 0));
  const Result<Distance> none = measure_distance(Drawing(), Drawing());
  ASSERT_TRUE(none);
  EXPECT_EQ(none->of_paths.distance, 0);
}

/// A chain that wanders; `turn` in 1..8 is how wildly.
Chain random_chain(std::mt19937& random, std::size_t steps, unsigned turn) {
  Chain chain;
  Step step = static_cast<Step>(random() % 8);
  for (std::size_t i = 0; i < steps; ++i) {
    if (random() % 8 < turn)
      step = static_cast<Step>((step + random() % 3 + 7) & 7);
    if (random() % 64 < turn) step ^= 4;
    chain.steps.push_back(step);
  }
  return chain;
}

std::vector<Point> points_of(const Chain& chain) {
  std::vector<Point> out{chain.origin};
  for (const Step step : chain.steps) {
    const Point d = step_delta(step, YAxis::up);
    out.push_back({out.back().x + d.x, out.back().y + d.y});
  }
  return out;
}

/// Through some of the chain's points, shaken by up to `shake` path units.
Path random_path(std::mt19937& random, const Chain& chain, std::int32_t scale,
                 int shake, bool arcs) {
  const std::vector<Point> points = points_of(chain);
  const auto shaken = [&](Point p) {
    const auto off = [&] {
      return static_cast<std::int32_t>(random() %
                                       static_cast<unsigned>(2 * shake + 1)) -
             shake;
    };
    return Point{p.x * scale + off(), p.y * scale + off()};
  };
  Path path;
  path.closed = chain.closed;
  path.origin = shaken(points[0]);
  Point at = path.origin;
  std::size_t i = 0;
  while (i + 1 < points.size()) {
    i = std::min<std::size_t>(i + 1 + random() % 9, points.size() - 1);
    Point to = i + 1 == points.size() && chain.closed ? path.origin
                                                      : shaken(points[i]);
    const Point move{to.x - at.x, to.y - at.y};
    if (arcs && random() % 2 == 0 && move != Point{}) {
      const auto far = static_cast<std::int32_t>(random() % 40) - 20;
      path.elements.push_back(
          arc({move.x / 2 - move.y * far / 8, move.y / 2 + move.x * far / 8},
              move, random() % 2 == 0));
      Arc& made = path.elements.back().arc;
      // The short way round most of the time.
      if (random() % 8 != 0) made.clockwise = far < 0;
    } else {
      path.elements.push_back(line(move.x, move.y));
    }
    at = to;
  }
  return path;
}

struct Kind {
  std::int32_t scale;
  int shake;
  bool arcs;
  bool closed;
};

class RandomDeviation : public ::testing::TestWithParam<Kind> {};

TEST_P(RandomDeviation, AgreesWithBruteForce) {
  const Kind kind = GetParam();
  const long double spacing_used = kind.closed ? 0.25L : 0.125L;
  for (unsigned seed = 0; seed < (kind.closed ? 24U : 50U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Chain chain = random_chain(random, 1 + random() % (kind.closed ? 8 : 20),
                               1 + seed % 5);
    chain.closed = kind.closed;
    if (kind.closed) {  // there and back
      for (std::size_t i = chain.steps.size(); i-- > 0;)
        chain.steps.push_back(chain.steps[i] ^ 4);
    }
    const Path path =
        random_path(random, chain, kind.scale, kind.shake, kind.arcs);
    const Pair pair(chain, path, kind.scale);
    const testing::Samples a = samples_of(chain, YAxis::up, spacing_used);
    const testing::Samples b = samples_of(path, kind.scale, spacing_used);
    const auto oracle = static_cast<double>(
        kind.closed ? discrete_frechet_closed(a, b) : discrete_frechet(a, b));
    const double spacing = 2 * static_cast<double>(spacing_used);
    const double found = pair.measured();
    EXPECT_GE(found, oracle - spacing);
    // A closed chain is measured from some starts only.
    if (!kind.closed) {
      // Chords of the samples are up to 0.01 inside of small arcs.
      EXPECT_LE(found, oracle + kFound + (kind.arcs ? 0.01 : 0));
    }
    EXPECT_TRUE(pair.within(found + kFound));
    if (oracle > spacing) {
      EXPECT_FALSE(pair.within(oracle - spacing));
    }
    if (!kind.closed && found > 0.01) {
      EXPECT_FALSE(pair.within(found - 0.001));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    , RandomDeviation,
    ::testing::Values(Kind{1, 0, false, false}, Kind{1, 1, false, false},
                      Kind{4, 3, false, false}, Kind{3, 7, false, false},
                      Kind{1, 1, true, false}, Kind{8, 5, true, false},
                      Kind{1, 1, false, true}, Kind{4, 3, false, true},
                      Kind{1, 0, true, true}, Kind{8, 5, true, true}));

}  // namespace
}  // namespace unstep
