#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "formats/histogram.h"
#include "raster_test_support.h"

namespace unstep {
namespace {

using test::error_of;
using test::has_note;
using test::read_raster;
using Kind = Threshold::Kind;

constexpr std::int32_t kWidth = 400;
constexpr std::int32_t kHeight = 300;

/// Bars of 1 to 8 pixels, a frame and a disc with a hole.
bool drawn(double x, double y) {
  if (x < 20 || y < 20 || x >= kWidth - 20 || y >= kHeight - 20) return false;
  const double middle = std::hypot(x - 300, y - 150);
  if (middle < 60) return middle > 15;
  if (x < 23 || y < 23 || x >= kWidth - 23 || y >= kHeight - 23) return true;
  if (x > 200) return false;
  const int bar = static_cast<int>(y - 30) / 24;
  return y >= 40 && x > 40 && static_cast<int>(y - 30) % 24 <= bar % 8;
}

using Light = std::function<double(double x, double y)>;

double even(double, double) { return 1; }
double uneven(double x, double y) {
  return 1 - 0.3 * x / kWidth - 0.25 * y / kHeight;
}

struct Page {
  Bitmap truth;
  test::PngRecipe png;
};

/// The drawing in ink of level 40 on paper of level 225, with noise; turned
/// about the middle, edges softened by supersampling.
Page make_page(const Light& light, double noise = 4, double degrees = 0,
               bool inverted = false) {
  Page page{*Bitmap::create(kWidth, kHeight), {}};
  page.png.width = kWidth;
  page.png.height = kHeight;
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  const double turn = degrees * std::acos(-1.0) / 180;
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      int ink = 0;
      for (int part = 0; part < 9; ++part) {
        const double px = x + (part % 3) / 3.0 - kWidth / 2.0;
        const double py = y + (part / 3) / 3.0 - kHeight / 2.0;
        if (drawn(px * std::cos(turn) - py * std::sin(turn) + kWidth / 2.0,
                  px * std::sin(turn) + py * std::cos(turn) + kHeight / 2.0)) {
          ++ink;
        }
      }
      page.truth.set(x, y, ink > 4);
      double level = (225 - 185.0 * ink / 9) * light(x, y);
      if (inverted) level = 255 - level;
      level += noise * normal(random);
      page.png.rows.push_back(
          static_cast<std::uint8_t>(std::clamp(std::lround(level), 0L, 255L)));
    }
  }
  return page;
}

RasterReadOptions with(Kind kind, PixelWork work = {}) {
  RasterReadOptions options;
  options.threshold.kind = kind;
  options.work = work;
  return options;
}

std::uint64_t differences(const Bitmap& a, const Bitmap& b) {
  std::uint64_t count = 0;
  for (std::int32_t y = 0; y < a.height(); ++y) {
    for (std::int32_t x = 0; x < a.width(); ++x) {
      count += a.get(x, y) != b.get(x, y) ? 1U : 0U;
    }
  }
  return count;
}

TEST(Histogram, FindsTheSplitOfTwoHeaps) {
  Histogram histogram{};
  histogram[40] = 10;
  histogram[44] = 30;
  histogram[200] = 100;
  EXPECT_EQ(otsu_level(histogram), 45);
  EXPECT_NEAR(share_below(histogram, 45), 40.0 / 140, 1e-9);
  EXPECT_EQ(mode_above(histogram, 45), 200);
  EXPECT_EQ(otsu_level(Histogram{}), 128) << "of nothing";
}

TEST(PixelWork, InvertsTwoValuesWithoutLoss) {
  const Bitmap ink = test::random_ink(70, 9, 2);
  RasterReadOptions options;
  options.work.invert = PixelWork::Invert::yes;
  const RasterPage page =
      read_raster(test::write_raster(RasterFormat::png, ink, {}), options);
  EXPECT_EQ(differences(page.ink, ink), ink.pixels());
  EXPECT_TRUE(page.lossless);
  EXPECT_EQ(test::value_of(page.info, "palette"), "#ffffff,#000000");
  EXPECT_EQ(test::value_of(page.info, "unstep:pixels"), "inverted");
  const RasterPage back =
      read_raster(test::write_raster(RasterFormat::png, page.ink, page.info));
  EXPECT_EQ(back.ink, ink) << "the PNG looks as before";
}

TEST(PixelWork, InvertsByItselfWhereMostIsDark) {
  Bitmap ink = *Bitmap::create(30, 10);
  for (std::int32_t x = 0; x < 30; ++x) ink.set(x, 4, true);
  RasterReadOptions options;
  options.work.invert = PixelWork::Invert::automatic;
  const auto read = [&](const Bitmap& page) {
    return read_raster(test::write_raster(RasterFormat::tiff, page, {}),
                       options);
  };
  EXPECT_EQ(read(ink).ink, ink);
  EXPECT_TRUE(read(ink).work.empty());
  Bitmap mostly = *Bitmap::create(30, 10);
  for (std::int32_t y = 0; y < 10; ++y) {
    for (std::int32_t x = 0; x < 30; ++x) mostly.set(x, y, !ink.get(x, y));
  }
  EXPECT_EQ(read(mostly).ink, ink);
}

TEST(PixelWork, InvertsAfterALevel) {
  const Page page = make_page(even, 4, 0, true);
  PixelWork work;
  work.invert = PixelWork::Invert::automatic;
  const RasterPage read =
      read_raster(test::make_png(page.png), with(Kind::otsu, work));
  EXPECT_LT(differences(read.ink, page.truth), 300U);
  ASSERT_EQ(read.work.size(), 2U);
  EXPECT_EQ(read.work[1], "inverted");
  EXPECT_FALSE(read.lossless);
}

#if UNSTEP_HAS_OPENCV

TEST(Binarise, FollowsTheLight) {
  const Page page = make_page(uneven);
  const test::Bytes file = test::make_png(page.png);
  const RasterPage local = read_raster(file, with(Kind::local));
  EXPECT_LT(differences(local.ink, page.truth), 400U);
  EXPECT_FALSE(local.lossless);
  EXPECT_TRUE(has_note(local,
                       "grey or colour pixels thresholded, not lossless: local "
                       "threshold, paper is "))
      << local.notes.at(0);
  EXPECT_EQ(test::value_of(local.info, "unstep:pixels").substr(0, 25),
            "local threshold, paper is");
  const RasterPage automatic = read_raster(file, with(Kind::automatic));
  EXPECT_EQ(automatic.ink, local.ink);
  EXPECT_EQ(automatic.work.at(0).substr(0, 23), "auto: local threshold, ");
  // The same page by one level.
  EXPECT_GT(differences(read_raster(file, with(Kind::otsu)).ink, page.truth),
            2 * differences(local.ink, page.truth));
}

TEST(Binarise, KeepsBroadInkWhole) {
  const Page page = make_page(even, 2);
  const RasterPage local =
      read_raster(test::make_png(page.png), with(Kind::local));
  EXPECT_TRUE(local.ink.get(300, 110)) << "inside the disc";
  EXPECT_FALSE(local.ink.get(300, 150)) << "its hole";
}

TEST(Binarise, MakesBlankPagesBlank) {
  for (const int level : {240, 30}) {
    test::PngRecipe png;
    png.width = png.height = 128;
    std::mt19937 random(5);
    for (int i = 0; i < 128 * 128; ++i) {
      png.rows.push_back(
          static_cast<std::uint8_t>(level + static_cast<int>(random() % 7)));
    }
    const RasterPage page =
        read_raster(test::make_png(png), with(Kind::automatic));
    EXPECT_EQ(page.ink.ink(), level > 128 ? 0U : 128U * 128U);
    EXPECT_NE(page.work.at(0).find("blank page"), std::string::npos);
  }
}

TEST(Binarise, TakesPagesOfEverySize) {
  for (const std::uint32_t width : {1U, 7U, 8U, 9U, 63U, 64U, 65U, 130U}) {
    for (const std::uint32_t height : {1U, 2U, 8U, 9U, 17U}) {
      test::PngRecipe png;
      png.width = width;
      png.height = height;
      for (std::uint32_t i = 0; i < width * height; ++i) {
        png.rows.push_back(static_cast<std::uint8_t>(i * 7919 % 251));
      }
      for (const Kind kind : {Kind::sauvola, Kind::local, Kind::automatic}) {
        const auto page = test::try_read(test::make_png(png), with(kind));
        ASSERT_TRUE(page) << page.error().message;
        for (std::int32_t y = 0; y < page->ink.height(); ++y) {
          EXPECT_EQ(page->ink.row(y).back() & ~page->ink.last_word_mask(), 0U);
        }
      }
    }
  }
}

TEST(Binarise, SauvolaPartsLinesFromPaper) {
  const Page page = make_page(even, 0);
  const RasterPage read =
      read_raster(test::make_png(page.png), with(Kind::sauvola));
  EXPECT_EQ(read.work.at(0), "threshold by sauvola");
  EXPECT_TRUE(read.ink.get(100, 103));
  EXPECT_FALSE(read.ink.get(210, 200));
}

TEST(Deskew, FindsTheAngleAndTurnsThePageBack) {
  const Page straight = make_page(even, 3);
  PixelWork work;
  work.deskew = true;
  for (const double degrees : {1.5, -3.0}) {
    const Page page = make_page(even, 3, degrees);
    const RasterPage read =
        read_raster(test::make_png(page.png), with(Kind::otsu, work));
    ASSERT_EQ(read.work.size(), 2U);
    double found = 0;
    ASSERT_EQ(std::sscanf(read.work[0].c_str(),
                          "deskew: was turned by %lf degrees", &found),
              1);
    EXPECT_NEAR(found, std::abs(degrees), 0.1);
    EXPECT_EQ(read.work[0].ends_with(" counter-clockwise"), degrees > 0)
        << read.work[0];
    EXPECT_GT(read.ink.width(), kWidth);
    // Middle to middle; half a pixel apart at most.
    const std::int32_t dx = (read.ink.width() - kWidth) / 2;
    const std::int32_t dy = (read.ink.height() - kHeight) / 2;
    std::uint64_t count = 0;
    for (std::int32_t y = 0; y < kHeight; ++y) {
      for (std::int32_t x = 0; x < kWidth; ++x) {
        count += read.ink.get(x + dx, y + dy) != straight.truth.get(x, y);
      }
    }
    EXPECT_LT(count, 5500U) << "of " << straight.truth.ink();
  }
}

TEST(Deskew, LeavesStraightPagesAlone) {
  const Page page = make_page(even);
  Bitmap ink = page.truth;
  RasterReadOptions options;
  options.work.deskew = true;
  const RasterPage read =
      read_raster(test::write_raster(RasterFormat::pbm, ink, {}), options);
  EXPECT_EQ(read.ink, ink);
  EXPECT_TRUE(read.lossless);
  EXPECT_EQ(read.work.at(0), "deskew: turned by 0.00 degrees, left so");
}

TEST(Deskew, TurnsBilevelPages) {
  const Page page = make_page(even, 0, 2);
  RasterReadOptions options;
  options.work.deskew = true;
  const RasterPage read = read_raster(
      test::write_raster(RasterFormat::pbm, page.truth, {}), options);
  EXPECT_FALSE(read.lossless);
  EXPECT_TRUE(has_note(read,
                       "pixels changed, not lossless: deskew: was turned "
                       "by 2.0"))
      << read.notes.at(0);
}

/// Labels by flood fill, the slow way.
Bitmap without_small(Bitmap ink, std::uint64_t area, bool of_paper) {
  const std::int32_t w = ink.width();
  const std::int32_t h = ink.height();
  Bitmap seen = *Bitmap::create(w, h);
  const Bitmap before = ink;
  for (std::int32_t y = 0; y < h; ++y) {
    for (std::int32_t x = 0; x < w; ++x) {
      if (before.get(x, y) == of_paper || seen.get(x, y)) continue;
      std::vector<std::pair<std::int32_t, std::int32_t>> piece{{x, y}};
      seen.set(x, y, true);
      bool at_edge = false;
      for (std::size_t i = 0; i < piece.size(); ++i) {
        const auto [px, py] = piece[i];
        at_edge = at_edge || px == 0 || py == 0 || px == w - 1 || py == h - 1;
        for (int d = 0; d < 9; ++d) {
          const std::int32_t nx = px + d % 3 - 1;
          const std::int32_t ny = py + d / 3 - 1;
          if (of_paper && d % 2 == 0) continue;  // corners
          if (nx < 0 || ny < 0 || nx >= w || ny >= h) continue;
          if (before.get(nx, ny) == of_paper || seen.get(nx, ny)) continue;
          seen.set(nx, ny, true);
          piece.emplace_back(nx, ny);
        }
      }
      if (piece.size() > area || (of_paper && at_edge)) continue;
      for (const auto& [px, py] : piece) ink.set(px, py, of_paper);
    }
  }
  return ink;
}

TEST(SmallPieces, GoAsByFloodFill) {
  std::mt19937 random(9);
  for (const std::int32_t height : {1, 40, 1100}) {
    for (const std::uint64_t area : {1U, 4U, 30U, 700U}) {
      Bitmap ink = *Bitmap::create(37, height);
      for (std::int32_t y = 0; y < height; ++y) {
        for (std::int32_t x = 0; x < 37; ++x) {
          ink.set(x, y, random() % 10 < (y % 200 < 100 ? 3U : 6U));
        }
      }
      for (const bool of_paper : {false, true}) {
        RasterReadOptions options;
        (of_paper ? options.work.fill_holes : options.work.despeckle) = area;
        const RasterPage read = read_raster(
            test::write_raster(RasterFormat::pbm, ink, {}), options);
        const Bitmap expected = without_small(ink, area, of_paper);
        ASSERT_EQ(differences(read.ink, expected), 0U)
            << height << " rows, area " << area << (of_paper ? " holes" : "");
        EXPECT_EQ(read.lossless, expected == ink);
      }
    }
  }
}

TEST(SmallPieces, AreCountedOnce) {
  Bitmap ink = *Bitmap::create(20, 1030);
  for (std::int32_t y = 505; y < 520; ++y) ink.set(3, y, true);  // two bands
  ink.set(9, 1029, true);
  ink.set(10, 1028, true);
  RasterReadOptions options;
  options.work.despeckle = 15;
  const RasterPage read =
      read_raster(test::write_raster(RasterFormat::pbm, ink, {}), options);
  EXPECT_EQ(read.ink.ink(), 0U);
  EXPECT_EQ(read.work.at(0), "2 specks of at most 15 px removed (17 px)");
}

TEST(Binarise, KeepsToTheMemoryLimit) {
  const Page page = make_page(even);
  RasterReadOptions options = with(Kind::automatic);
  const test::Bytes file = test::make_png(page.png);
  options.limits.max_memory = file.size() + 60000;
  EXPECT_EQ(error_of(file, options).substr(0, 14), "limit_exceeded");
}

#else

TEST(Binarise, SaysThatTheModuleIsMissing) {
  const Page page = make_page(uneven);
  EXPECT_EQ(error_of(test::make_png(page.png), with(Kind::local)).substr(0, 12),
            "unsupported:");
  (void)has_note({}, "");
}

#endif

}  // namespace
}  // namespace unstep
