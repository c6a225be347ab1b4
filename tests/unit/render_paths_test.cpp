#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "unit/container_testing.h"
#include "unit/digital_segment_testing.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

__extension__ using Wide = __int128;
using testing::below;
using testing::ink_of;
using testing::random_ink;

Path polygon(const std::vector<Point>& corners) {
  Path path{corners[0], true, 0, {}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& next = corners[(i + 1) % corners.size()];
    path.elements.push_back({Path::Kind::segment,
                             {next.x - corners[i].x, next.y - corners[i].y},
                             {}});
  }
  return path;
}

Path open_line(Point from, std::vector<Segment> moves, std::int32_t width) {
  Path path{from, false, width, {}};
  for (const Segment& move : moves)
    path.elements.push_back({Path::Kind::segment, move, {}});
  return path;
}

Path circle(Point centre, std::int32_t radius, bool clockwise = true) {
  Path path{{centre.x - radius, centre.y}, true, 0, {}};
  path.elements.push_back(
      {Path::Kind::arc, {}, {{radius, 0}, {0, 0}, clockwise}});
  return path;
}

Drawing drawing_of(std::vector<Path> paths, std::int32_t width,
                   std::int32_t height, std::int32_t scale = 1,
                   Paint paint = Paint::fill) {
  Drawing drawing;
  drawing.canvas = {width, height, YAxis::down};
  drawing.paths = std::move(paths);
  drawing.scale = scale;
  drawing.paint = paint;
  return drawing;
}

struct Line {
  Wide x0, y0, x1, y1;
};

/// Twice the coordinates, so that pixel centres are whole.
std::vector<Line> lines_of(const Drawing& drawing) {
  std::vector<Line> lines;
  for (const Path& path : drawing.paths) {
    Point at = path.origin;
    for (const Path::Element& e : path.elements) {
      const Point next{at.x + e.segment.dx, at.y + e.segment.dy};
      lines.push_back(
          {2 * Wide{at.x}, 2 * Wide{at.y}, 2 * Wide{next.x}, 2 * Wide{next.y}});
      at = next;
    }
  }
  return lines;
}

/// Every pixel against every line, straight from the definition.
Bitmap filled(const Drawing& drawing) {
  Bitmap ink = *Bitmap::create(drawing.canvas.width, drawing.canvas.height);
  const auto lines = lines_of(drawing);
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    for (std::int32_t x = 0; x < ink.width(); ++x) {
      const Wide px = (2 * Wide{x} + 1) * drawing.scale;
      const Wide py = (2 * Wide{y} + 1) * drawing.scale;
      bool inside = false;
      for (const Line& l : lines) {
        if ((l.y0 <= py) == (l.y1 <= py)) continue;
        const Wide side =
            (px - l.x0) * (l.y1 - l.y0) - (py - l.y0) * (l.x1 - l.x0);
        if (l.y1 > l.y0 ? side >= 0 : side <= 0) inside = !inside;
      }
      ink.set(x, y, inside);
    }
  }
  return ink;
}

Bitmap stroked(const Drawing& drawing) {
  Bitmap ink = *Bitmap::create(drawing.canvas.width, drawing.canvas.height);
  const auto lines = lines_of(drawing);
  const Wide radius = drawing.paths[0].width;  // in half units
  const auto near = [&](Wide px, Wide py, const Line& l) {
    const Wide dx = l.x1 - l.x0;
    const Wide dy = l.y1 - l.y0;
    const Wide square = dx * dx + dy * dy;
    const Wide along = (px - l.x0) * dx + (py - l.y0) * dy;
    const auto within = [&](Wide x, Wide y) {
      return (px - x) * (px - x) + (py - y) * (py - y) <= radius * radius;
    };
    if (along <= 0) return within(l.x0, l.y0);
    if (along >= square) return within(l.x1, l.y1);
    const Wide across = (px - l.x0) * dy - (py - l.y0) * dx;
    return across * across <= radius * radius * square;
  };
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    for (std::int32_t x = 0; x < ink.width(); ++x) {
      for (const Line& l : lines) {
        if (near((2 * Wide{x} + 1) * drawing.scale,
                 (2 * Wide{y} + 1) * drawing.scale, l))
          ink.set(x, y, true);
      }
    }
  }
  return ink;
}

Point random_point(std::mt19937& random, std::int32_t from, std::int32_t to) {
  const auto at = [&] {
    return from + static_cast<std::int32_t>(
                      below(random, static_cast<std::uint32_t>(to - from)));
  };
  const std::int32_t x = at();
  return {x, at()};
}

TEST(RenderPaths, NothingIsPaper) {
  EXPECT_EQ(*render_paths(drawing_of({}, 70, 3)), *Bitmap::create(70, 3));
}

TEST(RenderPaths, FillsPixelsWhoseCentresAreInside) {
  const Path square = polygon({{1, 1}, {4, 1}, {4, 3}, {1, 3}});
  EXPECT_EQ(*render_paths(drawing_of({square}, 6, 4)),
            ink_of({"......", ".###..", ".###..", "......"}));
  EXPECT_EQ(*render_paths(drawing_of(
                {square, polygon({{2, 1}, {3, 1}, {3, 3}, {2, 3}})}, 6, 4)),
            ink_of({"......", ".#.#..", ".#.#..", "......"}));
  EXPECT_EQ(*render_paths(drawing_of({square}, 3, 2, 2)),
            ink_of({"##.", "..."}))
      << "half units: centres on left and upper edges count, others do not";
}

TEST(RenderPaths, RandomPolygonsAreThoseOfTheDefinition) {
  std::mt19937 random(21);
  for (int i = 0; i < 150; ++i) {
    const std::int32_t scale = std::array{1, 2, 3, 7, 64}[below(random, 5)];
    std::vector<Path> paths;
    for (std::uint32_t k = below(random, 3) + 1; k > 0; --k) {
      std::vector<Point> corners(below(random, 7) + 1);
      for (Point& corner : corners)
        corner = random_point(random, -9 * scale, 40 * scale);
      paths.push_back(polygon(corners));
    }
    const Drawing drawing = drawing_of(paths, 33, 29, scale);
    ASSERT_EQ(*render_paths(drawing), filled(drawing)) << i;
  }
}

TEST(RenderPaths, CornersMayBeAsFarAwayAsCoordinatesGo) {
  std::mt19937 random(22);
  for (const std::int32_t scale : {1, 1000, Drawing::kMaxScale}) {
    for (int i = 0; i < 30; ++i) {
      std::vector<Point> corners(4);
      for (Point& corner : corners)
        corner = random_point(random, -kMaxCoord, kMaxCoord);
      corners[0] = {-kMaxCoord, kMaxCoord};
      const Drawing drawing = drawing_of({polygon(corners)}, 20, 20, scale);
      ASSERT_EQ(*render_paths(drawing), filled(drawing)) << i;
    }
  }
}

TEST(RenderPaths, ContoursComeBackAsTheInkTheyWereTracedFrom) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Bitmap ink = random_ink(75, 40, seed);
    Drawing drawing = drawing_of({}, 75, 40);
    ASSERT_TRUE(trace_contours(ink, [&](const Chain& contour) {
      Path path{contour.origin, true, 0, {}};
      for (const Step step : contour.steps) {
        const Point move = step_delta(step, YAxis::down);
        path.elements.push_back({Path::Kind::segment, {move.x, move.y}, {}});
      }
      drawing.paths.push_back(path);
      return true;
    }));
    EXPECT_EQ(*render_paths(drawing), ink);
  }
}

TEST(RenderPaths, YMayGrowUpwards) {
  Drawing drawing = drawing_of({polygon({{0, 0}, {3, 0}, {0, 2}})}, 4, 3);
  drawing.canvas.y_axis = YAxis::up;
  EXPECT_EQ(*render_paths(drawing), ink_of({"....", "#...", "##.."}));
}

/// Pixels whose centres are further than 1/64 from the circle are certain.
void check_circle(const Bitmap& ink, double cx, double cy, double radius,
                  bool (*part)(double dx, double dy)) {
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    for (std::int32_t x = 0; x < ink.width(); ++x) {
      const double dx = x + 0.5 - cx;
      const double dy = y + 0.5 - cy;
      const double out = std::hypot(dx, dy) - radius;
      if (std::abs(out) < 1.0 / 64) continue;
      ASSERT_EQ(ink.get(x, y), out < 0 && part(dx, dy)) << x << ' ' << y;
    }
  }
}

TEST(RenderPaths, CirclesAreRound) {
  for (const std::int32_t scale : {1, 16}) {
    for (const bool clockwise : {true, false}) {
      const Path path = circle({50 * scale, 40 * scale}, 37 * scale, clockwise);
      check_circle(*render_paths(drawing_of({path}, 100, 80, scale)), 50, 40,
                   37, [](double, double) { return true; });
    }
  }
}

/// A sector from east, `quarters` right angles in the sense of the numbers.
Path sector(int quarters, bool clockwise) {
  constexpr std::array<Point, 4> kEnds{{{0, 30}, {-30, 0}, {0, -30}, {30, 0}}};
  Point end = kEnds[static_cast<std::size_t>(quarters - 1)];
  if (clockwise) end.y = -end.y;
  Path path{{40, 40}, true, 0, {}};
  path.elements.push_back({Path::Kind::segment, {30, 0}, {}});
  path.elements.push_back(
      {Path::Kind::arc, {}, {{-30, 0}, {end.x - 30, end.y}, clockwise}});
  path.elements.push_back({Path::Kind::segment, {-end.x, -end.y}, {}});
  return path;
}

TEST(RenderPaths, ArcsTurnTheWayTheyAreMeant) {
  const auto check = [](int quarters, bool clockwise, auto part) {
    SCOPED_TRACE(quarters);
    check_circle(
        *render_paths(drawing_of({sector(quarters, clockwise)}, 80, 80)), 40,
        40, 30, part);
  };
  // The numbers of the canvas: y grows downwards.
  check(1, false, [](double x, double y) { return x > 0 && y > 0; });
  check(2, false, [](double, double y) { return y > 0; });
  check(3, false, [](double x, double y) { return !(x > 0 && y < 0); });
  check(1, true, [](double x, double y) { return x > 0 && y < 0; });
  check(2, true, [](double, double y) { return y < 0; });
  check(3, true, [](double x, double y) { return !(x > 0 && y > 0); });
}

TEST(RenderPaths, HugeCirclesCostOnlyWhatIsSeen) {
  // Nearly the whole coordinate range; its left edge crosses the canvas.
  constexpr std::int32_t radius = (1 << 29) - 10;
  const Path path = circle({20 + radius, 10}, radius);
  const Bitmap ink = *render_paths(drawing_of({path}, 41, 21));
  for (std::int32_t y = 0; y < 21; ++y) {
    EXPECT_FALSE(ink.get(19, y));
    EXPECT_TRUE(ink.get(20, y));
  }
}

TEST(RenderPaths, StrokesAreAllPixelsWithinHalfTheWidth) {
  std::mt19937 random(23);
  for (int i = 0; i < 120; ++i) {
    const std::int32_t scale = std::array{1, 2, 5, 32}[below(random, 4)];
    Path path = open_line(
        random_point(random, -5 * scale, 35 * scale), {},
        static_cast<std::int32_t>(
            below(random, static_cast<std::uint32_t>(12 * scale)) + 1));
    Point at = path.origin;
    for (std::uint32_t k = below(random, 4) + 1; k > 0; --k) {
      const Point to = random_point(random, -9 * scale, 40 * scale);
      path.elements.push_back(
          {Path::Kind::segment, {to.x - at.x, to.y - at.y}, {}});
      at = to;
    }
    const Drawing drawing = drawing_of({path}, 34, 30, scale, Paint::stroke);
    ASSERT_EQ(*render_paths(drawing), stroked(drawing)) << i;
  }
}

TEST(RenderPaths, StrokesFromFarAwayToFarAway) {
  std::mt19937 random(24);
  for (int i = 0; i < 40; ++i) {
    const Point from = random_point(random, -kMaxCoord / 2, 0);
    const Point to = random_point(random, 0, kMaxCoord / 2);
    const Path path = open_line(from, {{to.x - from.x, to.y - from.y}},
                                i % 2 == 0 ? 9 : kMaxCoord / 3);
    const Drawing drawing = drawing_of({path}, 20, 20, 1, Paint::stroke);
    ASSERT_EQ(*render_paths(drawing), stroked(drawing)) << i;
  }
}

TEST(RenderPaths, StrokesHaveRoundEndsAndDots) {
  EXPECT_EQ(*render_paths(
                drawing_of({open_line({3, 2}, {}, 4)}, 6, 4, 1, Paint::stroke)),
            ink_of({"..##..", ".####.", ".####.", "..##.."}));
  EXPECT_EQ(*render_paths(drawing_of({open_line({2, 2}, {{3, 0}}, 4)}, 8, 4, 1,
                                     Paint::stroke)),
            ink_of({".#####..", "#######.", "#######.", ".#####.."}));
  const Bitmap ring = *render_paths([] {
    Path path = circle({20, 20}, 15);
    path.width = 4;
    return drawing_of({path}, 40, 40, 1, Paint::stroke);
  }());
  for (std::int32_t y = 0; y < 40; ++y) {
    for (std::int32_t x = 0; x < 40; ++x) {
      const double off =
          std::abs(std::hypot(x + 0.5 - 20, y + 0.5 - 20) - 15) - 2;
      if (std::abs(off) < 1.0 / 64) continue;
      ASSERT_EQ(ring.get(x, y), off < 0) << x << ' ' << y;
    }
  }
}

TEST(RenderPaths, AWidthOfNothingDrawsTheNearestPixels) {
  const auto draw = [](const Path& path, std::int32_t scale = 1) {
    return *render_paths(drawing_of({path}, 8, 4, scale, Paint::stroke));
  };
  EXPECT_EQ(draw(open_line({0, 0}, {{7, 3}}, 0)),
            ink_of({"##......", "..##....", "....##..", "......##"}));
  EXPECT_EQ(draw(open_line({7, 0}, {{0, 3}}, 0)),
            ink_of({".......#", ".......#", ".......#", ".......#"}));
  EXPECT_EQ(draw(open_line({3, 3}, {{-2, -2}, {2, -1}}, 0)),
            ink_of({"..##....", ".#......", "..#.....", "...#...."}));
  EXPECT_EQ(draw(open_line({5, 2}, {}, 0)),
            ink_of({"........", "........", ".....#..", "........"}));
  EXPECT_EQ(draw(open_line({11, 5}, {{17, 5}}, 0), 4),
            ink_of({"........", "...#....", "....####", "........"}));
  EXPECT_EQ(draw(open_line({-kMaxCoord, 1}, {{kMaxCoord, 0}}, 0)),
            ink_of({"........", "#.......", "........", "........"}));
}

TEST(RenderPaths, OpenPathsAreNotFilled) {
  Path path = polygon({{0, 0}, {3, 0}, {0, 3}});
  path.closed = false;
  EXPECT_EQ(render_paths(drawing_of({path}, 4, 4))->ink(), 0U);
}

TEST(RenderPaths, RefusesWhatIsNoDrawing) {
  const auto message = [](Drawing drawing) {
    const Result<Bitmap> ink = render_paths(drawing);
    return ink ? std::string() : ink.error().message;
  };
  const Path square = polygon({{1, 1}, {4, 1}, {4, 3}, {1, 3}});
  EXPECT_EQ(message(drawing_of({square}, 0, 4)), "the canvas has no size");
  EXPECT_EQ(message(drawing_of({square}, 4, 4, 0)),
            "scale 0 is not in 1..1048576");
  Path bad = square;
  bad.elements.pop_back();
  EXPECT_EQ(message(drawing_of({square, bad}, 4, 4)),
            "path 2: does not return to its origin");
  bad.elements[1].segment.dy = kMaxCoord;
  EXPECT_EQ(message(drawing_of({bad}, 4, 4)),
            "path 1: leaves the coordinate range at element 2");
  bad.origin.x = kMaxCoord + 1;
  EXPECT_EQ(message(drawing_of({bad}, 4, 4)),
            "path 1: starts outside the coordinate range");
  bad = square;
  bad.width = -1;
  EXPECT_EQ(message(drawing_of({bad}, 4, 4)),
            "path 1: width -1 is not in 0..1073741823");
}

}  // namespace
}  // namespace unstep
