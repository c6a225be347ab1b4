#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "common/stroke_scenes.h"
#include "trace/skeleton_graph.h"
#include "unit/container_testing.h"
#include "unstep/codec.h"
#include "unstep/deviation.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

using testing::ink_of;
using testing::kSceneKinds;
using testing::Scene;
using testing::SceneKind;
using testing::SceneMaker;

Canvas canvas_of(const Bitmap& ink) {
  return {ink.width(), ink.height(), YAxis::down};
}

std::vector<Stroke> traced(const Bitmap& ink) {
  Result<std::vector<Stroke>> strokes = trace_strokes(ink);
  EXPECT_TRUE(strokes) << strokes.error().message;
  return strokes ? *std::move(strokes) : std::vector<Stroke>();
}

Bitmap drawn(const Bitmap& ink, const std::vector<Stroke>& strokes,
             const Rational& tolerance) {
  const Result<Drawing> drawing =
      stroke_paths(strokes, canvas_of(ink), {tolerance});
  EXPECT_TRUE(drawing) << drawing.error().message;
  Result<Bitmap> pixels = render_paths(*drawing);
  EXPECT_TRUE(pixels) << pixels.error().message;
  return *std::move(pixels);
}

/// The share of strokes found as one piece with both ends within 2 pixels.
double share_found(bool noise) {
  std::size_t found = 0;
  std::size_t wanted = 0;
  for (const SceneKind kind : kSceneKinds) {
    for (int width = 1; width <= 20; ++width) {
      const auto seed = static_cast<std::uint32_t>(
          width * 100 + static_cast<int>(kind) * 10'000);
      const Scene scene = SceneMaker(kind, width, seed).make(noise);
      found += testing::count_found(scene, traced(scene.ink), 2);
      wanted += scene.strokes.size();
    }
  }
  return static_cast<double>(found) / static_cast<double>(wanted);
}

TEST(Strokes, AreFoundInOnePieceWithTheirEnds) {
  EXPECT_GE(share_found(false), 0.97);
}

TEST(Strokes, AreFoundInNoise) { EXPECT_GE(share_found(true), 0.95); }

TEST(Strokes, HaveTheWidthOfThePen) {
  for (int width = 1; width <= 20; ++width) {
    const Scene scene =
        SceneMaker(SceneKind::line, width, static_cast<std::uint32_t>(width))
            .make(false);
    for (const Stroke& stroke : traced(scene.ink)) {
      ASSERT_EQ(stroke.pieces.size(), 1U) << width;
      EXPECT_NEAR(stroke.pieces[0].width / 2.0, width, 0.75);
    }
  }
}

TEST(Strokes, DrawWhatTheyWereTracedFrom) {
  for (const SceneKind kind : kSceneKinds) {
    for (const int width : {1, 2, 5, 12}) {
      const Scene scene =
          SceneMaker(kind, width, static_cast<std::uint32_t>(width))
              .make(false);
      const std::vector<Stroke> strokes = traced(scene.ink);
      const auto found =
          measure_ink(scene.ink, drawn(scene.ink, strokes, {0, 1}));
      ASSERT_TRUE(found) << found.error().message;
      EXPECT_LE(found->worst().distance(), 3) << width;
    }
  }
}

TEST(Strokes, KeepACrossingAsTwoLinesAndABarAsOne) {
  const Bitmap cross =
      ink_of({".....#.....", ".....#.....", ".....#.....", ".....#.....",
              ".....#.....", "###########", ".....#.....", ".....#.....",
              ".....#.....", ".....#.....", ".....#....."});
  EXPECT_EQ(traced(cross).size(), 2U);
  const Bitmap tee = ink_of({"###########", ".....#.....", ".....#.....",
                             ".....#.....", ".....#.....", ".....#....."});
  const std::vector<Stroke> strokes = traced(tee);
  ASSERT_EQ(strokes.size(), 2U);
  EXPECT_EQ(strokes[0].chain.steps.size(), 10U);
  EXPECT_EQ(strokes[1].chain.steps.size(), 5U);
}

TEST(Strokes, OfSmallThings) {
  const std::vector<Stroke> dot = traced(ink_of({"...", ".#.", "..."}));
  ASSERT_EQ(dot.size(), 1U);
  EXPECT_TRUE(dot[0].chain.steps.empty());
  EXPECT_EQ(dot[0].chain.origin, (Point{1, 1}));
  const std::vector<Stroke> pixel = traced(ink_of({"#"}));
  EXPECT_EQ(pixel.size(), 1U);
  EXPECT_TRUE(traced(ink_of({"....", "...."})).empty());
  EXPECT_FALSE(traced(ink_of({"####", "####", "####"})).empty());
  const std::vector<Stroke> ring =
      traced(ink_of({".###.", "#...#", "#...#", "#...#", ".###."}));
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_TRUE(ring[0].chain.closed);
  EXPECT_FALSE(trace_strokes(Bitmap()));
}

TEST(Strokes, TurnUpForAnyInk) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    Bitmap ink = *Bitmap::create(std::int64_t{1} + seed * 7 % 90,
                                 std::int64_t{1} + seed * 11 % 60);
    const std::uint32_t percent = seed * 17 % 100;
    for (std::int32_t y = 0; y < ink.height(); ++y) {
      for (std::int32_t x = 0; x < ink.width(); ++x) {
        ink.set(x, y, random() % 100 < percent);
      }
    }
    const std::vector<Stroke> strokes = traced(ink);
    for (const Rational& tolerance :
         {Rational{0, 1}, Rational{1, 4}, Rational{1, 1}}) {
      const auto drawing = stroke_paths(strokes, canvas_of(ink), {tolerance});
      ASSERT_TRUE(drawing) << drawing.error().message;
    }
    for (const Stroke& stroke : strokes) {
      std::size_t steps = 0;
      for (const Stroke::Piece& piece : stroke.pieces) {
        EXPECT_GE(piece.width, 1);
        steps += piece.steps;
      }
      EXPECT_EQ(steps, stroke.chain.steps.size()) << seed;
    }
  }
}

/// Two rows of letters of lines, each with pixels of its own at its edges.
Bitmap rough_letters() {
  Bitmap ink = *Bitmap::create(400, 120);
  std::mt19937 random(4);
  for (std::int32_t i = 0; i < 24; ++i) {
    const std::int32_t x = 12 + 32 * (i % 12);
    const std::int32_t y = 14 + 56 * (i / 12);
    for (std::int32_t k = 0; k < 27; ++k) {
      for (std::int32_t w = 0; w < 3; ++w) {
        ink.set(x + w, y + k, true);
        if (k < 18) ink.set(x + k, y + w + (i % 2 == 0 ? 0 : 12), true);
      }
    }
    for (std::int32_t k = 4; k < 24; k += 5) {
      if (random() % 2 == 0) ink.set(x - 1, y + k, true);
    }
  }
  return ink;
}

/// The chains of strokes' pieces, in the order of their paths.
Drawing chains_of(const std::vector<Stroke>& strokes) {
  Drawing chains;
  for (const Stroke& stroke : strokes) {
    EXPECT_EQ(stroke.pieces.size(), 1U);
    chains.chains.push_back(stroke.chain);
  }
  return chains;
}

TEST(Strokes, OfFewBytesStayWithinTheTolerance) {
  const Bitmap ink = rough_letters();
  const std::vector<Stroke> strokes = traced(ink);
  StrokeOptions options;
  options.aim = LineAim::few_bytes;
  const Result<Drawing> cheap = stroke_paths(strokes, canvas_of(ink), options);
  ASSERT_TRUE(cheap) << cheap.error().message;
  // Paths are in half pixels and go through the middles of pixels, (2x + 1,
  // 2y + 1), where chains have (x, y). Lines three pixels wide are not shifted
  // beside their chains, so nothing but the tolerance lies between the two.
  Drawing paths = *cheap;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    EXPECT_EQ(strokes[i].shift, (Point{0, 0}));
    Point& at = paths.paths[i].origin;
    at = {at.x - 1, at.y - 1};
  }
  const auto far = measure_deviation(chains_of(strokes), paths);
  ASSERT_TRUE(far) << far.error().message;
  EXPECT_LE(far->distance, 1);
  EXPECT_LT(cheap->paths.size(), 60U);
}

TEST(Strokes, ThatAreAlikeBecomeTheSamePaths) {
  const Bitmap ink = rough_letters();
  const std::vector<Stroke> strokes = traced(ink);
  const auto kinds = [&](LineAim aim) {
    StrokeOptions options;
    options.aim = aim;
    const Result<Drawing> drawing =
        stroke_paths(strokes, canvas_of(ink), options);
    EXPECT_TRUE(drawing);
    std::vector<std::vector<Path::Element>> seen;
    for (const Path& path : drawing->paths) {
      if (std::find(seen.begin(), seen.end(), path.elements) == seen.end()) {
        seen.push_back(path.elements);
      }
    }
    return seen.size();
  };
  EXPECT_LE(kinds(LineAim::few_bytes), 6U);
}

TEST(Strokes, StayWithinTwoPixelsOfTheInkIfTheyAreToldIt) {
  Bitmap ink = rough_letters();
  for (std::int32_t i = 0; i < 14; ++i) {
    for (std::int32_t k = 0; k <= i; ++k) ink.set(300 + i, 100 + k, true);
  }
  for (const std::uint32_t tolerance : {0U, 1U, 3U}) {
    StrokeOptions options;
    options.tolerance = {tolerance, 1};
    options.aim = LineAim::few_bytes;
    options.ink = &ink;
    const Result<Drawing> drawing =
        stroke_paths(traced(ink), canvas_of(ink), options);
    ASSERT_TRUE(drawing) << drawing.error().message;
    const Result<Bitmap> pixels = render_paths(*drawing);
    ASSERT_TRUE(pixels);
    const Result<InkDistance> far = measure_ink(ink, *pixels);
    ASSERT_TRUE(far);
    EXPECT_LE(far->of_a.distance(), std::max(2.0, 1.0 + tolerance));
  }
}

Stroke stroke_of(Point origin, std::size_t steps, std::int32_t width) {
  Stroke stroke;
  stroke.chain.origin = origin;
  stroke.chain.steps.assign(steps, 0);
  stroke.pieces = {{steps, width}};
  return stroke;
}

/// What few bytes within one pixel make of the strokes, the ink told.
std::vector<Path> cheap_paths(const Bitmap& ink,
                              const std::vector<Stroke>& strokes) {
  StrokeOptions options;
  options.aim = LineAim::few_bytes;
  options.ink = &ink;
  Result<Drawing> drawing = stroke_paths(strokes, canvas_of(ink), options);
  EXPECT_TRUE(drawing) << drawing.error().message;
  return drawing ? std::move(drawing->paths) : std::vector<Path>();
}

TEST(Strokes, OfFewBytesHaveDotsOnlyWhereInkIsMissing) {
  Bitmap ink = *Bitmap::create(60, 40);
  for (std::int32_t x = 4; x < 40; ++x) ink.set(x, 10, true);
  ink.set(20, 11, true);
  ink.set(50, 30, true);
  // The second is beside the line, which is near enough to its ink.
  std::vector<Stroke> strokes{stroke_of({4, 10}, 35, 2),
                              stroke_of({20, 11}, 0, 2),
                              stroke_of({50, 30}, 0, 2)};
  const std::vector<Path> paths = cheap_paths(ink, strokes);
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(paths[0].elements.size(), 1U);
  EXPECT_EQ(paths[1].origin, (Point{101, 61}));
}

TEST(Strokes, OfFewBytesHaveDotsAfterWhatTheyStandBeside) {
  Bitmap ink = *Bitmap::create(60, 40);
  for (std::int32_t x = 4; x < 40; ++x) {
    ink.set(x, 10, true);
    ink.set(x, 30, true);
  }
  ink.set(20, 14, true);
  std::vector<Stroke> strokes{stroke_of({4, 10}, 35, 2),
                              stroke_of({4, 30}, 35, 2)};
  strokes[1].group = 1;
  const std::vector<Path> paths = cheap_paths(ink, strokes);
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_EQ(paths[1].elements.size(), 0U);
  EXPECT_EQ(paths[1].origin, (Point{41, 29}));
}

TEST(Strokes, OfFewBytesGoThroughTheMiddlesOfPixels) {
  Bitmap ink = *Bitmap::create(60, 20);
  for (std::int32_t x = 4; x < 40; ++x) {
    ink.set(x, 10, true);
    ink.set(x, 11, true);
  }
  std::vector<Stroke> strokes{stroke_of({4, 10}, 35, 4)};
  strokes[0].shift = {0, 1};
  EXPECT_EQ(cheap_paths(ink, strokes)[0].origin, (Point{9, 21}));
  const Result<Drawing> exact = stroke_paths(strokes, canvas_of(ink), {{0, 1}});
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->paths[0].origin, (Point{9, 22}));
}

TEST(Strokes, OfAStringOfTextStandTogether) {
  // Beside something high, two strings one above the other.
  Bitmap ink = *Bitmap::create(80, 60);
  const auto bar = [&](std::int32_t x, std::int32_t top, std::int32_t bottom) {
    for (std::int32_t y = top; y <= bottom; ++y) ink.set(x, y, true);
  };
  bar(4, 2, 50);
  for (const std::int32_t x : {30, 38, 46}) bar(x, 5, 15);
  for (const std::int32_t x : {34, 42, 50}) bar(x, 25, 35);
  std::vector<std::int32_t> order;
  for (const Stroke& stroke : traced(ink)) {
    order.push_back(stroke.chain.origin.x);
  }
  EXPECT_EQ(order, (std::vector<std::int32_t>{4, 30, 38, 46, 34, 42, 50}));
}

TEST(Strokes, StandInGroupsThatTouch) {
  const std::vector<Stroke> strokes = traced(rough_letters());
  std::uint32_t last = 0;
  for (const Stroke& stroke : strokes) {
    EXPECT_TRUE(stroke.group == last || stroke.group == last + 1);
    last = stroke.group;
  }
  EXPECT_EQ(last, 23U);
}

TEST(Strokes, SayThatTheirPiecesDoNotFit) {
  Stroke stroke;
  stroke.chain.steps = {0, 0};
  stroke.pieces = {{3, 2}};
  const std::vector<Stroke> strokes{stroke};
  EXPECT_FALSE(stroke_paths(strokes, {9, 9, YAxis::down}, {}));
}

TEST(Strokes, StopWhenAsked) {
  const Scene scene = SceneMaker(SceneKind::crossing, 9, 3).make(false);
  const auto stopped = trace_strokes(
      scene.ink, [](std::uint64_t, std::uint64_t) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

TEST(SkeletonGraph, HasEveryPixelOnce) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    Bitmap ink = *Bitmap::create(70, 50);
    for (int i = 0; i < 12; ++i) {
      const auto x = static_cast<std::int32_t>(random() % 60);
      const auto y = static_cast<std::int32_t>(random() % 40);
      for (int k = 0; k < 60; ++k) {
        ink.set(x + static_cast<std::int32_t>(random() % 10),
                y + static_cast<std::int32_t>(random() % 10), true);
      }
    }
    Bitmap skeleton = ink;
    ASSERT_TRUE(thin(skeleton));
    const auto graph = trace::graph_of(ink, skeleton);
    ASSERT_TRUE(graph);
    Bitmap seen = *Bitmap::create(ink.width(), ink.height());
    std::uint64_t count = 0;
    const auto add = [&](const std::vector<trace::Spot>& spots) {
      for (const trace::Spot& spot : spots) {
        seen.set(spot.at.x, spot.at.y, true);
        ++count;
      }
    };
    for (const auto& junction : graph->junctions) add(junction.spots);
    for (const auto& branch : graph->branches) {
      add(branch.spots);
      for (std::size_t i = 1; i < branch.spots.size(); ++i) {
        const Point a = branch.spots[i - 1].at;
        const Point b = branch.spots[i].at;
        EXPECT_TRUE(std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1);
      }
    }
    EXPECT_EQ(seen, skeleton) << seed;
    EXPECT_EQ(count, skeleton.ink()) << seed;
  }
}

TEST(Strokes, ComeBackFromAFile) {
  const Scene scene = SceneMaker(SceneKind::tee, 5, 11).make(true);
  const auto drawing =
      stroke_paths(traced(scene.ink), canvas_of(scene.ink), {{1, 1}});
  ASSERT_TRUE(drawing);
  UstpWriter writer{EncodeOptions{}};
  const Fidelity fidelity{Fidelity::Kind::tolerance, {1, 1}};
  ASSERT_TRUE(writer.add_page(*drawing, {}, fidelity));
  const auto file = writer.finish();
  ASSERT_TRUE(file);
  const auto reader = UstpReader::open(*file, {});
  ASSERT_TRUE(reader);
  const auto page = reader->read_page(0);
  ASSERT_TRUE(page);
  EXPECT_EQ(page->drawing, *drawing);
  EXPECT_EQ(page->fidelity, fidelity);
}

}  // namespace
}  // namespace unstep
