#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "machine/esu.h"

namespace unstep::machine {
namespace {

/// A circle, a disc and lines 1 to 5 points wide, away from the borders.
Bitmap drawing(std::int32_t side) {
  Bitmap page = *Bitmap::create(side, side);
  const double middle = side / 2.0;
  for (std::int32_t y = 0; y < side; ++y)
    for (std::int32_t x = 0; x < side; ++x) {
      const double r = std::hypot(x - middle, y - middle);
      const bool circle = std::abs(r - side * 0.4) < 1.5;
      const bool disc = r < side * 0.1;
      const bool line =
          x > 9 && y > 9 && x < side / 2 && y % 50 < 1 + y / 50 % 5;
      if (circle || disc || line) page.set(x, y, true);
    }
  return page;
}

/// Has every ink point of `one` ink of `other` within `distance`?
bool near(const Bitmap& one, const Bitmap& other, int distance) {
  for (std::int32_t y = 0; y < one.height(); ++y)
    for (std::int32_t x = 0; x < one.width(); ++x) {
      if (!one.get(x, y)) continue;
      bool found = false;
      for (int j = -distance; j <= distance && !found; ++j)
        for (int i = -distance; i <= distance && !found; ++i)
          found = i * i + j * j <= distance * distance && x + i >= 0 &&
                  y + j >= 0 && x + i < other.width() &&
                  y + j < other.height() && other.get(x + i, y + j);
      if (!found) return false;
    }
  return true;
}

TEST(Esu, SteadyRasterAndFineSpotReadEveryPoint) {
  EsuOptions options;
  options.instability = 0;
  options.spot_um = 3;
  const Bitmap page = drawing(300);
  const auto film = esu_scan(page, options);
  ASSERT_TRUE(film);
  EXPECT_EQ(*film_ink(*film), page);
  EXPECT_EQ(std::ranges::max(film->transmission), kEsuClear);
  EXPECT_DOUBLE_EQ(esu_seconds(*film), 0.9);
}

TEST(Esu, SteadyRasterWritesWhatItIsGiven) {
  EsuOptions options;
  options.instability = 0;
  options.spot_um = 3;
  const Bitmap page = drawing(300);
  const auto film = esu_write(page, options);
  ASSERT_TRUE(film);
  EXPECT_EQ(*film_ink(*film), page);
}

TEST(Esu, ScanStaysWithin5PointsOfTheDrawing) {
  const Bitmap page = drawing(500);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    EsuOptions options;
    options.seed = seed;
    const auto film = esu_scan(page, options);
    ASSERT_TRUE(film);
    const auto scanned = film_ink(*film);
    ASSERT_TRUE(scanned);
    EXPECT_TRUE(near(*scanned, page, 5));
    EXPECT_TRUE(near(page, *scanned, 5));
    EXPECT_NE(*scanned, page);
  }
}

TEST(Esu, WritingStaysWithin5PointsOfTheDrawing) {
  const Bitmap page = drawing(500);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    EsuOptions options;
    options.seed = seed;
    const auto film = esu_write(page, options);
    ASSERT_TRUE(film);
    const auto written = film_ink(*film);
    EXPECT_TRUE(near(*written, page, 5));
    EXPECT_TRUE(near(page, *written, 5));
    EXPECT_NE(*written, page);
  }
}

TEST(Esu, BeamErrorIsThatOfTheInstability) {
  EsuOptions options;
  const auto error = esu_beam_error(drawing(500), options);
  ASSERT_TRUE(error);
  // 2.05 points of 4 um on each axis.
  EXPECT_LE(error->worst_um, 2.05 * 4 * std::sqrt(2.0));
  EXPECT_GT(error->rms_um, 0);
  EXPECT_LT(error->rms_um, error->worst_um);
  options.instability = 0;
  EXPECT_EQ(esu_beam_error(drawing(500), options)->worst_um, 0);
  EXPECT_EQ(esu_beam_error(*Bitmap::create(9, 9), {})->rms_um, 0);
  EXPECT_FALSE(esu_beam_error(*Bitmap::create(kEsuField + 1, 1), {}));
}

TEST(Esu, MoreInstabilityLeavesThe5Points) {
  const Bitmap page = drawing(500);
  EsuOptions options;
  options.instability = 0.01;
  const auto film = esu_scan(page, options);
  ASSERT_TRUE(film);
  EXPECT_FALSE(near(*film_ink(*film), page, 5));
}

TEST(Esu, WrittenAndScannedAgainItIsWithin7Points) {
  const Bitmap page = drawing(500);
  const auto written = esu_write(page, {});
  ASSERT_TRUE(written);
  EsuOptions later;
  later.seed = 2;
  const auto film = esu_scan(*film_ink(*written), later);
  ASSERT_TRUE(film);
  const auto scanned = film_ink(*film);
  EXPECT_TRUE(near(*scanned, page, 7));
  EXPECT_TRUE(near(page, *scanned, 7));
}

TEST(Esu, InstabilityIsThatOfTheWholeField) {
  // The column of a line, read at every row of the full height.
  Bitmap page = *Bitmap::create(64, kEsuField);
  for (std::int32_t y = 0; y < kEsuField; ++y)
    for (std::int32_t x = 30; x < 34; ++x) page.set(x, y, true);
  const auto film = esu_scan(page, {});
  ASSERT_TRUE(film);
  EXPECT_NEAR(esu_seconds(*film), 2.62, 0.01);
  const auto ink = film_ink(*film);
  for (std::int32_t y = 0; y < kEsuField; ++y) {
    EXPECT_FALSE(ink->get(27, y) || ink->get(36, y)) << y;
  }
}

TEST(Esu, EdgeOfTheFieldIsClearBeyond) {
  Bitmap page = *Bitmap::create(1, 1);
  page.set(0, 0, true);
  EsuOptions options;
  options.instability = 0;
  const auto film = esu_scan(page, options);
  ASSERT_TRUE(film);
  EXPECT_GT(film->transmission[0], 20);
  EXPECT_LT(film->transmission[0], 64);
  EXPECT_EQ(film_ink(*film)->ink(), 1U);
}

TEST(Esu, RefusesWhatItCannotDo) {
  const auto refused = [](const Bitmap& page, EsuOptions options) {
    const auto read = esu_scan(page, options);
    const auto written = esu_write(page, options);
    return !read && !written && read.error().code == ErrorCode::out_of_range;
  };
  EXPECT_TRUE(refused(*Bitmap::create(kEsuField + 1, 1), {}));
  EXPECT_TRUE(refused(*Bitmap::create(1, kEsuField + 1), {}));
  EXPECT_TRUE(refused(Bitmap(), {}));
  EsuOptions options;
  options.spot_um = 6;
  EXPECT_TRUE(refused(*Bitmap::create(1, 1), options));
  options = {};
  options.instability = NAN;
  EXPECT_TRUE(refused(*Bitmap::create(1, 1), options));
  EXPECT_FALSE(film_ink(Film{1, 1, {0}}, 0));
  EXPECT_FALSE(film_ink(Film{}, 64));
}

}  // namespace
}  // namespace unstep::machine
