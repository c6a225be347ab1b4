#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "unstep/interpolate.h"
#include "unstep/reverse.h"

namespace unstep {
namespace {

Path::Element line(std::int32_t dx, std::int32_t dy) {
  return {Path::Kind::segment, {dx, dy}, {}};
}

Path::Element arc(Point centre, Point end, bool clockwise) {
  return {Path::Kind::arc, {}, {centre, end, clockwise}};
}

Drawing drawing_of(Path path, YAxis axis = YAxis::down) {
  Drawing drawing;
  drawing.canvas = {100, 100, axis};
  drawing.paths.push_back(std::move(path));
  return drawing;
}

Point end_of(const Chain& chain, YAxis axis) {
  Point at = chain.origin;
  for (const Step step : chain.steps) {
    const Point move = step_delta(step, axis);
    at = {at.x + move.x, at.y + move.y};
  }
  return at;
}

TEST(StepPaths, LinesEndOnTheVerticesWhateverTheAxis) {
  for (const YAxis axis : {YAxis::up, YAxis::down}) {
    const Drawing drawing =
        drawing_of({{3, 4}, false, 0, {line(7, 3), line(-2, -9)}}, axis);
    const Result<Drawing> steps = step_paths(drawing, {});
    ASSERT_TRUE(steps);
    ASSERT_EQ(steps->chains.size(), 1U);
    EXPECT_EQ(steps->chains[0].origin, (Point{3, 4}));
    EXPECT_EQ(steps->chains[0].steps.size(), 16U);
    EXPECT_EQ(end_of(steps->chains[0], axis), (Point{8, -2}));
  }
}

TEST(StepPaths, AQuarterTurnsByItsNumbersWhateverTheAxis) {
  // From (10, 0) about (0, 0) to (0, 10): the angle of the numbers grows.
  const Drawing down =
      drawing_of({{10, 0}, false, 0, {arc({-10, 0}, {-10, 10}, false)}});
  const Result<Drawing> steps = step_paths(down, {});
  ASSERT_TRUE(steps);
  EXPECT_EQ(end_of(steps->chains[0], YAxis::down), (Point{0, 10}));
  Point at = steps->chains[0].origin;
  for (const Step step : steps->chains[0].steps) {
    const Point move = step_delta(step, YAxis::down);
    at = {at.x + move.x, at.y + move.y};
    EXPECT_NEAR(std::hypot(at.x, at.y), 10.0, 1.0);
    EXPECT_GE(at.x, 0);
    EXPECT_GE(at.y, 0);
  }
}

TEST(StepPaths, ACircleOffTheGridIsDrawnToItsEnd) {
  // Radius 2.5 grid units: neither centre nor ends are grid points.
  Drawing drawing =
      drawing_of({{5, 0}, true, 0, {arc({-5, 0}, {0, 0}, false)}}, YAxis::up);
  drawing.scale = 2;
  const Result<Drawing> steps = step_paths(drawing, {});
  ASSERT_TRUE(steps);
  const Chain& chain = steps->chains[0];
  EXPECT_TRUE(chain.closed);
  EXPECT_EQ(end_of(chain, YAxis::up), chain.origin);
  Point at = chain.origin;
  for (const Step step : chain.steps) {
    const Point move = step_delta(step);
    at = {at.x + move.x, at.y + move.y};
    EXPECT_NEAR(std::hypot(at.x, at.y), 2.5, 1.21);
  }
}

TEST(StepPaths, GivesBackWhatTheDeviceDraws) {
  std::mt19937 random(1984);
  std::vector<Step> steps(2000);
  for (Step& step : steps) step = static_cast<Step>(random() % 4 * 2);
  const Result<std::vector<Segment>> segments = reverse_device(steps);
  ASSERT_TRUE(segments);
  std::size_t count = 0;
  for (const Segment& segment : *segments) {
    count += static_cast<std::size_t>(step_count(Method::device, segment));
  }
  std::vector<Step> drawn(count);
  ASSERT_TRUE(interpolate(Method::device, *segments, drawn));
  Path path;
  for (const Segment& segment : *segments) {
    path.elements.push_back(line(segment.dx, -segment.dy));
  }
  const Result<Drawing> again =
      step_paths(drawing_of(path), {Method::device, 1.0, 1U << 20});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->chains[0].steps, drawn);
}

TEST(StepPaths, AFinerGridHasMoreSteps) {
  const Drawing drawing = drawing_of({{0, 0}, false, 0, {line(100, 40)}});
  const Result<Drawing> fine =
      step_paths(drawing, {Method::evaluation8, 0.25, 1000});
  ASSERT_TRUE(fine);
  EXPECT_EQ(fine->chains[0].steps.size(), 400U);
  EXPECT_EQ(fine->canvas.width, 400);
}

TEST(StepPaths, RefusesWhatItCannotDraw) {
  const Drawing drawing = drawing_of({{0, 0}, false, 0, {line(100, 40)}});
  const auto code = [&](const StepOptions& options) {
    return step_paths(drawing, options).error().code;
  };
  EXPECT_EQ(code({Method::evaluation8, 0.0, 1000}),
            ErrorCode::invalid_argument);
  EXPECT_EQ(code({Method::cordic, 1.0, 1000}), ErrorCode::invalid_argument);
  EXPECT_EQ(code({Method::evaluation8, 1.0, 99}), ErrorCode::limit_exceeded);
  EXPECT_EQ(code({Method::evaluation8, 1e-9, 1000}), ErrorCode::out_of_range);
  Drawing huge =
      drawing_of({{0, 0}, false, 0, {arc({kMaxCoord, 1}, {0, 0}, true)}});
  EXPECT_EQ(step_paths(huge, {Method::evaluation8, 1.0, 1000}).error().code,
            ErrorCode::limit_exceeded);
}

}  // namespace
}  // namespace unstep
