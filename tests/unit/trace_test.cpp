#include "unstep/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "unit/container_testing.h"

namespace unstep {
namespace {

using testing::ink_of;

std::vector<Chain> trace(const Bitmap& ink) {
  std::vector<Chain> contours;
  const Status done = trace_contours(ink, [&](const Chain& contour) {
    contours.push_back(contour);
    return true;
  });
  EXPECT_TRUE(done) << done.error().message;
  return contours;
}

bool pixel(const Bitmap& ink, std::int32_t x, std::int32_t y) {
  return x >= 0 && y >= 0 && x < ink.width() && y < ink.height() &&
         ink.get(x, y);
}

/// How often each crack is in a contour, the horizontal ones before the
/// vertical ones; checks that each walk is closed and has its colour on the
/// right hand.
std::vector<int> count_cracks(const Bitmap& ink,
                              const std::vector<Chain>& contours) {
  const std::int32_t stride = ink.width() + 1;
  const std::int32_t points = stride * (ink.height() + 1);
  std::vector<int> counts(static_cast<std::size_t>(points) * 2);
  for (const Chain& contour : contours) {
    EXPECT_TRUE(contour.closed);
    EXPECT_EQ(contour.connectivity, Connectivity::four);
    EXPECT_EQ(contour.steps.at(0), 0);
    Point at = contour.origin;
    const bool right = pixel(ink, at.x, at.y);
    for (const Step step : contour.steps) {
      const Point move = step_delta(step, YAxis::down);
      const Point next{at.x + move.x, at.y + move.y};
      const Point low{std::min(at.x, next.x), std::min(at.y, next.y)};
      ++counts[static_cast<std::size_t>(low.y * stride + low.x +
                                        (move.y != 0 ? points : 0))];
      // The pixels on either hand of the crack.
      const Point south{low.x, low.y};
      const Point other =
          move.y == 0 ? Point{low.x, low.y - 1} : Point{low.x - 1, low.y};
      const bool right_is_south = step == 0 || step == 2;
      EXPECT_EQ(pixel(ink, south.x, south.y), right_is_south ? right : !right);
      EXPECT_EQ(pixel(ink, other.x, other.y), right_is_south ? !right : right);
      at = next;
    }
    EXPECT_EQ(at, contour.origin);
  }
  return counts;
}

/// 1 for each crack that lies between ink and paper, in the same order.
std::vector<int> true_cracks(const Bitmap& ink) {
  std::vector<int> counts;
  for (const bool vertical : {false, true}) {
    for (std::int32_t y = 0; y <= ink.height(); ++y) {
      for (std::int32_t x = 0; x <= ink.width(); ++x) {
        const bool other =
            vertical ? pixel(ink, x - 1, y) : pixel(ink, x, y - 1);
        counts.push_back(pixel(ink, x, y) != other ? 1 : 0);
      }
    }
  }
  return counts;
}

/// 8-connected components of ink and 4-connected ones of paper, the paper
/// around the raster not counted: as many as there are contours.
std::size_t count_components(const Bitmap& ink) {
  const std::int32_t width = ink.width() + 2;
  const std::int32_t height = ink.height() + 2;
  std::vector<bool> seen(static_cast<std::size_t>(width * height));
  std::size_t components = 0;
  for (std::int32_t start = 0; start < width * height; ++start) {
    if (seen[static_cast<std::size_t>(start)]) continue;
    ++components;
    const bool colour = pixel(ink, start % width - 1, start / width - 1);
    std::vector<std::int32_t> open{start};
    seen[static_cast<std::size_t>(start)] = true;
    while (!open.empty()) {
      const std::int32_t at = open.back();
      open.pop_back();
      for (unsigned step = 0; step < 8; step += colour ? 1 : 2) {
        const Point move = step_delta(static_cast<Step>(step));
        const std::int32_t x = at % width + move.x;
        const std::int32_t y = at / width + move.y;
        if (x < 0 || y < 0 || x >= width || y >= height) continue;
        const auto to = static_cast<std::size_t>(y * width + x);
        if (seen[to] || pixel(ink, x - 1, y - 1) != colour) continue;
        seen[to] = true;
        open.push_back(y * width + x);
      }
    }
  }
  return components - 1;
}

void expect_right(const Bitmap& ink) {
  const std::vector<Chain> contours = trace(ink);
  EXPECT_TRUE(count_cracks(ink, contours) == true_cracks(ink))
      << "every crack is in one contour";
  EXPECT_EQ(contours.size(), count_components(ink));
  EXPECT_TRUE(
      std::ranges::is_sorted(contours, [](const Chain& a, const Chain& b) {
        return std::pair(a.origin.y, a.origin.x) <
               std::pair(b.origin.y, b.origin.x);
      }));
  const Result<Bitmap> filled =
      fill_contours(contours, ink.width(), ink.height());
  ASSERT_TRUE(filled) << filled.error().message;
  EXPECT_TRUE(*filled == ink) << "filling the contours draws the ink again";
}

Bitmap noise(std::int32_t width, std::int32_t height, unsigned percent,
             unsigned seed) {
  Bitmap ink = *Bitmap::create(width, height);
  std::mt19937 random(seed);
  for (std::int32_t y = 0; y < height; ++y) {
    for (std::int32_t x = 0; x < width; ++x) {
      ink.set(x, y, random() % 100 < percent);
    }
  }
  return ink;
}

TEST(TraceContours, GoesClockwiseAroundOnePixel) {
  const std::vector<Chain> contours = trace(ink_of({"...", ".#.", "..."}));
  ASSERT_EQ(contours.size(), 1U);
  EXPECT_EQ(contours[0],
            (Chain{{1, 1}, Connectivity::four, true, {0, 6, 4, 2}}));
}

TEST(TraceContours, HasPaperOnTheRightHandOfAHole) {
  const std::vector<Chain> contours = trace(ink_of({"###", "#.#", "###"}));
  ASSERT_EQ(contours.size(), 2U);
  EXPECT_EQ(contours[0].origin, (Point{0, 0}));
  EXPECT_EQ(contours[0].steps.size(), 12U);
  EXPECT_EQ(contours[1],
            (Chain{{1, 1}, Connectivity::four, true, {0, 6, 4, 2}}));
}

TEST(TraceContours, KeepsInkThatTouchesAtACornerInOneContour) {
  const std::vector<Chain> falling = trace(ink_of({"#.", ".#"}));
  ASSERT_EQ(falling.size(), 1U);
  EXPECT_EQ(
      falling[0],
      (Chain{{0, 0}, Connectivity::four, true, {0, 6, 0, 6, 4, 2, 4, 2}}));
  const std::vector<Chain> rising = trace(ink_of({".#", "#."}));
  ASSERT_EQ(rising.size(), 1U);
  EXPECT_EQ(
      rising[0],
      (Chain{{1, 0}, Connectivity::four, true, {0, 6, 4, 6, 4, 2, 0, 2}}));
}

TEST(TraceContours, SeparatesHolesThatTouchAtACorner) {
  EXPECT_EQ(trace(ink_of({"####", "#.##", "##.#", "####"})).size(), 3U);
}

TEST(TraceContours, VisitsEveryCrackOnceForAnyDensity) {
  unsigned seed = 0;
  for (const unsigned percent : {0U, 1U, 20U, 50U, 80U, 99U, 100U}) {
    for (const auto& [width, height] :
         std::vector<std::pair<std::int32_t, std::int32_t>>{{1, 1},
                                                            {1, 90},
                                                            {200, 1},
                                                            {2, 2},
                                                            {63, 9},
                                                            {64, 20},
                                                            {65, 20},
                                                            {130, 70}}) {
      SCOPED_TRACE(::testing::Message()
                   << percent << " % of " << width << " x " << height);
      expect_right(noise(width, height, percent, ++seed));
    }
  }
}

TEST(TraceContours, VisitsEveryCrackOnceForEverySmallRaster) {
  for (unsigned bits = 0; bits < 1U << 12; ++bits) {
    Bitmap ink = *Bitmap::create(4, 3);
    for (int i = 0; i < 12; ++i) ink.set(i % 4, i / 4, (bits >> i & 1) != 0);
    expect_right(ink);
    if (HasFailure()) FAIL() << "pixels " << bits;
  }
}

TEST(TraceContours, StopsWhenTheVisitorWantsTo) {
  const Bitmap ink = ink_of({"#.#.#"});
  int visits = 0;
  const Status stopped =
      trace_contours(ink, [&](const Chain&) { return ++visits < 2; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
  EXPECT_EQ(visits, 2);
}

TEST(TraceContours, RefusesAnEmptyBitmap) {
  const Status status =
      trace_contours(Bitmap(), [](const Chain&) { return true; });
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace unstep
