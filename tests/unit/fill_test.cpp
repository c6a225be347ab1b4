#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "unit/container_testing.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

using testing::ink_of;

/// A rectangle as a contour, clockwise as seen.
Chain rectangle(Point at, int width, int height) {
  Chain chain{at, Connectivity::four, true, {}};
  const auto go = [&](Step step, int count) {
    chain.steps.insert(chain.steps.end(), static_cast<std::size_t>(count),
                       step);
  };
  go(0, width);
  go(6, height);
  go(4, width);
  go(2, height);
  return chain;
}

ErrorCode code_of(const Chain& chain) {
  const Result<Bitmap> ink = fill_contours(std::vector{chain}, 10, 5);
  return ink ? ErrorCode::internal : ink.error().code;
}

TEST(FillContours, NothingIsPaper) {
  EXPECT_EQ(*fill_contours({}, 70, 3), *Bitmap::create(70, 3));
}

TEST(FillContours, FillsTheWholeRaster) {
  for (const std::int32_t width : {1, 63, 64, 65, 128, 200}) {
    const Result<Bitmap> ink =
        fill_contours(std::vector{rectangle({0, 0}, width, 3)}, width, 3);
    ASSERT_TRUE(ink);
    EXPECT_EQ(ink->ink(), static_cast<std::uint64_t>(width) * 3);
    EXPECT_EQ(ink->row(0).back() & ~ink->last_word_mask(), 0U);
  }
}

TEST(FillContours, CountsCrossingsByParity) {
  const std::vector<Chain> overlapping{rectangle({0, 0}, 4, 2),
                                       rectangle({2, 1}, 3, 2)};
  EXPECT_EQ(*fill_contours(overlapping, 6, 3),
            ink_of({"####..", "##..#.", "..###."}));
  const std::vector<Chain> twice(2, rectangle({1, 1}, 3, 2));
  EXPECT_EQ(*fill_contours(twice, 6, 4), *Bitmap::create(6, 4));
}

TEST(FillContours, DoesNotMindTheDirectionOrAPointlessWalk) {
  Chain chain{{1, 1}, Connectivity::four, true, {6, 6, 0, 2, 2, 4}};
  EXPECT_EQ(*fill_contours(std::vector{chain}, 3, 3),
            ink_of({"...", ".#.", ".#."}));
  chain.steps = {6, 0, 4, 2};
  EXPECT_EQ(*fill_contours(std::vector{chain}, 3, 3), *Bitmap::create(3, 3));
  chain.steps.clear();
  EXPECT_EQ(*fill_contours(std::vector{chain}, 3, 3), *Bitmap::create(3, 3));
}

TEST(FillContours, RefusesChainsThatAreNotContours) {
  Chain chain = rectangle({0, 0}, 2, 2);
  chain.closed = false;
  EXPECT_EQ(code_of(chain), ErrorCode::invalid_argument);
  chain = rectangle({0, 0}, 2, 2);
  chain.steps.pop_back();
  EXPECT_EQ(code_of(chain), ErrorCode::invalid_argument);
  chain.steps = {0, 1, 4};
  EXPECT_EQ(code_of(chain), ErrorCode::invalid_argument);
  chain.steps = {0, 8};
  EXPECT_EQ(code_of(chain), ErrorCode::invalid_argument);
}

TEST(FillContours, RefusesChainsThatLeaveTheRaster) {
  EXPECT_EQ(code_of(rectangle({0, 0}, 10, 5)), ErrorCode::internal) << "fits";
  EXPECT_EQ(code_of(rectangle({0, 0}, 11, 5)), ErrorCode::out_of_range);
  EXPECT_EQ(code_of(rectangle({0, 0}, 10, 6)), ErrorCode::out_of_range);
  EXPECT_EQ(code_of(rectangle({-1, 0}, 3, 3)), ErrorCode::out_of_range);
  EXPECT_EQ(code_of(rectangle({11, 0}, 0, 0)), ErrorCode::out_of_range);
  EXPECT_EQ(code_of({{0, 0}, Connectivity::four, true, {2, 6}}),
            ErrorCode::out_of_range);
  EXPECT_EQ(code_of({{kMaxCoord, 0}, Connectivity::four, true, {}}),
            ErrorCode::out_of_range);
}

TEST(FillContours, NamesTheChainAndTheStep) {
  const std::vector<Chain> chains{rectangle({0, 0}, 2, 2),
                                  rectangle({9, 0}, 2, 2)};
  EXPECT_EQ(fill_contours(chains, 10, 5).error().message,
            "chain 2: leaves the raster at step 2");
}

TEST(FillContours, RefusesARasterWithoutPixels) {
  EXPECT_EQ(fill_contours({}, 0, 5).error().code, ErrorCode::out_of_range);
  EXPECT_EQ(fill_contours({}, 5, -1).error().code, ErrorCode::out_of_range);
}

}  // namespace
}  // namespace unstep
