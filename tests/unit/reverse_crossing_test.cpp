#include <gtest/gtest.h>

#include <string>

#include "reverse/crossing.h"
#include "unit/frechet_oracle.h"
#include "unit/reverse_tolerance_chains.h"
#include "unstep/formats.h"
#include "unstep/reverse.h"

namespace unstep {
namespace {

using namespace testing;
using reverse::LineVertices;

struct Line {
  Place a;
  Place b;
  std::size_t path;
  std::size_t index;
};

int side(const Place& a, const Place& b, const Place& c) {
  const long double o = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return (o > 0) - (o < 0);
}

/// The lines of all paths, by brute force: how many pairs cross between their
/// ends.
std::size_t crossings(const std::vector<Path>& paths, std::int32_t scale) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Polyline vertices = polyline_of(paths[i], scale);
    for (std::size_t k = 0; k + 1 < vertices.size(); ++k) {
      lines.push_back({vertices[k], vertices[k + 1], i, k});
    }
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Line& p = lines[i];
      const Line& q = lines[k];
      count += side(p.a, p.b, q.a) * side(p.a, p.b, q.b) < 0 &&
               side(q.a, q.b, p.a) * side(q.a, q.b, p.b) < 0;
    }
  }
  return count;
}

void expect_no_crossings(const std::vector<Chain>& contours, Effort effort) {
  for (const Rational& e : {Rational{1, 2}, Rational{3, 4}, Rational{1, 1}}) {
    Drawing drawing;
    drawing.chains = contours;
    ToleranceReport report;
    ToleranceOptions options{e, effort, false};
    const auto result = reverse_tolerance(drawing, options, &report);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(crossings(result->paths, result->scale), 0U)
        << e.numerator << '/' << e.denominator;
    std::uint64_t segments = 0;
    for (std::size_t i = 0; i < contours.size(); ++i) {
      segments += result->paths[i].elements.size();
      EXPECT_TRUE(
          path_within(contours[i], YAxis::down, result->paths[i], result->scale,
                      static_cast<long double>(e.numerator) / e.denominator));
    }
    EXPECT_EQ(report.segments, segments);
    EXPECT_LE(report.refined, contours.size());
  }
}

LineVertices vertices(const std::vector<Point>& points) {
  LineVertices result;
  for (const Point& point : points) result.push_back({result.size(), point});
  return result;
}

std::size_t found(const std::vector<LineVertices>& paths,
                  const std::vector<bool>& closed) {
  const std::vector<reverse::Box> all{reverse::kEverywhere};
  return reverse::find_crossings(paths, closed, all, 16).size();
}

TEST(Crossing, FindsLinesThatCrossBetweenTheirEnds) {
  EXPECT_GT(found({vertices({{0, 0}, {10, 10}}), vertices({{0, 9}, {9, 0}})},
                  {false, false}),
            0U);
  EXPECT_EQ(found({vertices({{0, 0}, {10, 10}}), vertices({{6, 5}, {9, 0}})},
                  {false, false}),
            0U);
}

TEST(Crossing, FindsPathsThatChangeSidesAtAVertex) {
  const auto level = vertices({{0, 0}, {10, 0}, {20, 0}});
  const auto through = vertices({{3, -5}, {5, 0}, {8, 5}});
  const auto touching = vertices({{3, 5}, {5, 0}, {8, 5}});
  const auto joint = vertices({{8, -5}, {10, 0}, {12, 5}});
  const auto end = vertices({{3, -5}, {5, 0}});
  EXPECT_GT(found({level, through}, {false, false}), 0U);
  EXPECT_EQ(found({level, touching}, {false, false}), 0U);
  EXPECT_GT(found({level, joint}, {false, false}), 0U);
  EXPECT_EQ(found({level, end}, {false, false}), 0U);
}

TEST(Crossing, FindsLinesOnEachOther) {
  EXPECT_GT(found({vertices({{0, 0}, {10, 5}}), vertices({{4, 2}, {14, 7}})},
                  {false, false}),
            0U);
  EXPECT_EQ(found({vertices({{0, 0}, {10, 5}}), vertices({{10, 5}, {14, 7}})},
                  {false, false}),
            0U);
}

TEST(Crossing, IsExactAtTheEndsOfTheCoordinateRange) {
  const std::int32_t m = kMaxCoord;
  const auto rising = vertices({{-m, -m}, {m, m}});
  EXPECT_GT(found({rising, vertices({{-m, m}, {m, -m}})}, {false, false}), 0U);
  EXPECT_EQ(
      found({rising, vertices({{-m, -m + 1}, {m - 1, m}})}, {false, false}),
      0U);
}

TEST(Crossing, AgreesWithBruteForceOnRandomLines) {
  std::mt19937 random(5);
  for (int run = 0; run < 50; ++run) {
    std::vector<LineVertices> paths;
    std::vector<Path> drawn;
    const std::int32_t size = run % 2 == 0 ? 40 : 4000;
    for (int i = 0; i < 20; ++i) {
      const auto coordinate = [&] {
        return static_cast<std::int32_t>(random() %
                                         static_cast<std::uint32_t>(size));
      };
      const Point a{coordinate(), coordinate()};
      const Point b{coordinate() + size, coordinate()};
      paths.push_back(vertices({a, b}));
      Path path;
      path.origin = a;
      path.elements.push_back({});
      path.elements[0].segment = {b.x - a.x, b.y - a.y};
      drawn.push_back(path);
    }
    const std::vector<bool> closed(paths.size());
    const std::vector<reverse::Box> all{reverse::kEverywhere};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const auto& pair : reverse::find_crossings(paths, closed, all, 16)) {
      pairs.push_back(std::minmax(pair.first.path, pair.second.path));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    // Lines on each other are found too, but are rare here.
    EXPECT_EQ(pairs.size(), crossings(drawn, 1));
  }
}

TEST(ReverseTolerance, SimpleContoursDoNotCross) {
  std::mt19937 random(6);
  for (const std::uint32_t sticking : {0U, 100U, 180U, 230U}) {
    for (const Effort effort : {Effort::standard, Effort::max}) {
      expect_no_crossings(contours_of(blots(random, 40, sticking)), effort);
    }
  }
}

TEST(ReverseTolerance, ThinRingsDoNotCross) {
  for (const std::int32_t radius : {5, 12, 30, 55}) {
    expect_no_crossings(contours_of(disc(radius, radius - 1)),
                        Effort::standard);
    expect_no_crossings(contours_of(disc(radius, radius)), Effort::standard);
  }
}

TEST(ReverseTolerance, ContoursOfTheSamplesDoNotCross) {
  for (const char* name : {"glyph.pbm", "crown.png", "molecule-8bit.png"}) {
    const auto bytes =
        read_file(std::string(UNSTEP_SOURCE_DIR "/samples/") + name, 1U << 24);
    ASSERT_TRUE(bytes);
    auto file = RasterReader::open(*bytes, {});
    ASSERT_TRUE(file);
    expect_no_crossings(contours_of(file->read(0)->ink), Effort::standard);
  }
}

TEST(ReverseTolerance, ChainsThatCrossAreLeftAlone) {
  // A figure of two bars that cross, as centrelines do.
  Drawing drawing;
  drawing.chains.push_back(open_chain(std::vector<Step>(40, 0), {0, 20}));
  drawing.chains.push_back(open_chain(std::vector<Step>(40, 6), {20, 0}));
  drawing.chains.push_back(open_chain(std::vector<Step>(40, 7), {0, 0}));
  ToleranceReport report;
  const auto result = reverse_tolerance(drawing, {}, &report);
  ASSERT_TRUE(result);
  EXPECT_EQ(report.segments, 3U);
  EXPECT_EQ(report.refined, 0U);
}

TEST(ReverseTolerance, ReportsThePathsThatWereMadeFiner) {
  // Noise is so dense that some lines cross at first.
  std::mt19937 random(7);
  Drawing drawing;
  for (int run = 0; run < 8; ++run) {
    drawing.chains = contours_of(blots(random, 60, 0));
    ToleranceReport report;
    ASSERT_TRUE(reverse_tolerance(drawing, {}, &report));
    if (report.refined > 0) return;
  }
  FAIL() << "no path was refined";
}

}  // namespace
}  // namespace unstep
