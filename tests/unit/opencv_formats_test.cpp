#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "raster_test_support.h"

namespace unstep {
namespace {

using test::Bytes;
using test::error_of;
using test::has_note;
using test::packed_rows;
using test::random_ink;
using test::read_raster;

/// 16 x 8 pixels, the left half black, JFIF density 204 x 98 per inch.
const Bytes kJpeg{
    0xff, 0xd8, 0xff, 0xe0, 0x00, 0x10, 0x4a, 0x46, 0x49, 0x46, 0x00, 0x01,
    0x01, 0x01, 0x00, 0xcc, 0x00, 0x62, 0x00, 0x00, 0xff, 0xdb, 0x00, 0x43,
    0x00, 0x08, 0x06, 0x06, 0x07, 0x06, 0x05, 0x08, 0x07, 0x07, 0x07, 0x09,
    0x09, 0x08, 0x0a, 0x0c, 0x14, 0x0d, 0x0c, 0x0b, 0x0b, 0x0c, 0x19, 0x12,
    0x13, 0x0f, 0x14, 0x1d, 0x1a, 0x1f, 0x1e, 0x1d, 0x1a, 0x1c, 0x1c, 0x20,
    0x24, 0x2e, 0x27, 0x20, 0x22, 0x2c, 0x23, 0x1c, 0x1c, 0x28, 0x37, 0x29,
    0x2c, 0x30, 0x31, 0x34, 0x34, 0x34, 0x1f, 0x27, 0x39, 0x3d, 0x38, 0x32,
    0x3c, 0x2e, 0x33, 0x34, 0x32, 0xff, 0xc0, 0x00, 0x0b, 0x08, 0x00, 0x08,
    0x00, 0x10, 0x01, 0x01, 0x11, 0x00, 0xff, 0xc4, 0x00, 0x14, 0x00, 0x01,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x08, 0xff, 0xc4, 0x00, 0x14, 0x10, 0x01, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0xff, 0xda, 0x00, 0x08, 0x01, 0x01, 0x00, 0x00, 0x3f, 0x00,
    0x3f, 0x9f, 0xef, 0xff, 0xd9};

/// The same with an EXIF orientation, in an APP1 segment after the JFIF one.
Bytes turned_jpeg(std::uint8_t orientation) {
  const Bytes exif{0xff, 0xe1,        0,   34,  'E', 'x', 'i', 'f', 0,
                   0,    'I',         'I', '*', 0,   8,   0,   0,   0,
                   1,    0,           18,  1,   3,   0,   1,   0,   0,
                   0,    orientation, 0,   0,   0,   0,   0,   0,   0};
  Bytes file = kJpeg;
  file.insert(file.begin() + 20, exif.begin(), exif.end());
  return file;
}

struct BmpRecipe {
  std::int32_t width = 8;
  std::int32_t height = 1;  ///< below 0: first row first
  std::uint32_t bits = 1;
  Bytes palette;  ///< blue, green, red, 0
  Bytes rows;     ///< as stored
};

Bytes make_bmp(const BmpRecipe& recipe) {
  Bytes file{'B', 'M'};
  const auto put = [&file](std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) {
      file.push_back(static_cast<std::uint8_t>(value >> 8 * i));
    }
  };
  const auto data = static_cast<std::uint32_t>(54 + recipe.palette.size());
  put(data + static_cast<std::uint32_t>(recipe.rows.size()), 4);
  put(0, 4);
  put(data, 4);
  put(40, 4);
  put(static_cast<std::uint32_t>(recipe.width), 4);
  put(static_cast<std::uint32_t>(recipe.height), 4);
  put(1, 2);
  put(recipe.bits, 2);
  put(0, 4);
  put(static_cast<std::uint32_t>(recipe.rows.size()), 4);
  put(11811, 4);
  put(3937, 4);
  put(static_cast<std::uint32_t>(recipe.palette.size() / 4), 4);
  put(0, 4);
  file.insert(file.end(), recipe.palette.begin(), recipe.palette.end());
  file.insert(file.end(), recipe.rows.begin(), recipe.rows.end());
  return file;
}

/// One bit a pixel, rows filled up to four bytes, last row first.
BmpRecipe bilevel_bmp(const Bitmap& ink) {
  BmpRecipe recipe;
  recipe.width = ink.width();
  recipe.height = ink.height();
  recipe.palette = {0, 0, 0, 0, 255, 255, 255, 0};
  const std::size_t row = (static_cast<std::size_t>(ink.width()) + 7) / 8;
  for (std::int32_t y = ink.height() - 1; y >= 0; --y) {
    Bytes bytes((row + 3) / 4 * 4);
    ink.get_row_bytes(y, std::span(bytes).first(row), true);
    recipe.rows.insert(recipe.rows.end(), bytes.begin(), bytes.end());
  }
  return recipe;
}

bool opencv_is_loaded() {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    if (line.find("opencv") != std::string::npos) return true;
  }
  return false;
}

TEST(OpencvModule, IsNotLoadedForBilevelFormats) {
  if (opencv_is_loaded()) {
    GTEST_SKIP() << "another test of this process has loaded the module; "
                    "ctest runs this one alone";
  }
  const Bitmap ink = random_ink(70, 9, 2);
  for (const RasterFormat format :
       {RasterFormat::pbm, RasterFormat::png, RasterFormat::tiff}) {
    EXPECT_EQ(read_raster(test::write_raster(format, ink, {})).ink, ink);
  }
  EXPECT_EQ(read_raster(make_bmp(bilevel_bmp(ink))).ink, ink);
  EXPECT_FALSE(opencv_is_loaded());
}

TEST(BmpReader, ReadsOneBitImagesOfEveryWidth) {
  for (const std::int32_t width : {1, 7, 8, 31, 32, 33, 64, 65, 130}) {
    const Bitmap ink = random_ink(width, 7, 2);
    const RasterPage page = read_raster(make_bmp(bilevel_bmp(ink)));
    EXPECT_EQ(page.ink, ink);
    EXPECT_EQ(page.info.resolution,
              (Resolution{{11811, 1}, {3937, 1}, Resolution::Unit::metre}));
    EXPECT_TRUE(page.info.metadata.empty());
  }
}

TEST(BmpReader, HonoursPaletteAndRowOrder) {
  BmpRecipe recipe;
  recipe.height = -2;
  recipe.palette = {255, 255, 255, 0, 0x33, 0x22, 0x11, 0};
  recipe.rows = {0xa5, 0, 0, 0, 0x0f, 0, 0, 0};
  const RasterPage page = read_raster(make_bmp(recipe));
  EXPECT_EQ(packed_rows(page.ink, false), (Bytes{0xa5, 0x0f}));
  EXPECT_EQ(test::value_of(page.info, "palette"), "#112233,#ffffff");
}

TEST(BmpReader, SurvivesTruncationAndFlippedBits) {
  const Bytes file = make_bmp(bilevel_bmp(random_ink(13, 5, 2)));
  for (std::size_t size = 0; size < file.size(); ++size) {
    EXPECT_NE(error_of({file.begin(),
                        file.begin() + static_cast<std::ptrdiff_t>(size)}),
              "no error");
  }
  for (std::size_t bit = 0; bit < file.size() * 8; ++bit) {
    Bytes bad = file;
    bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ 1U << bit % 8);
    if (bad[28] == 1 && bad[30] == 0) (void)test::try_read(bad);
  }
}

TEST(BmpReader, RejectsGiantImagesBeforeItAllocates) {
  BmpRecipe recipe;
  recipe.width = 1000000000;
  recipe.height = 1000000000;
  for (const std::uint32_t bits : {1U, 24U}) {
    recipe.bits = bits;
    EXPECT_EQ(error_of(make_bmp(recipe)).substr(0, 14), "limit_exceeded");
  }
}

#if UNSTEP_HAS_OPENCV

TEST(BmpReader, ReadsOtherDepthsThroughTheModule) {
  BmpRecipe recipe;
  recipe.width = 4;
  recipe.height = 1;
  recipe.bits = 24;
  recipe.rows = {0x33, 0x22, 0x11, 255,  255,  255,
                 255,  255,  255,  0x33, 0x22, 0x11};
  RasterPage page = read_raster(make_bmp(recipe));
  EXPECT_EQ(packed_rows(page.ink, false), Bytes{0x90});
  EXPECT_EQ(test::value_of(page.info, "palette"), "#112233,#ffffff");
  EXPECT_EQ(page.info.resolution.x, (Rational{11811, 1}));
  EXPECT_TRUE(opencv_is_loaded());
  Bytes cut = make_bmp(recipe);
  cut.pop_back();
  EXPECT_EQ(error_of(cut).substr(0, 10), "truncated:");
}

#endif

TEST(JpegReader, ReadsPixelsAndDensity) {
  const RasterPage page = read_raster(kJpeg);
  EXPECT_EQ(page.ink.width(), 16);
  ASSERT_EQ(page.ink.height(), 8);
  EXPECT_EQ(packed_rows(page.ink, false).front(), 0xff);
  EXPECT_EQ(packed_rows(page.ink, false)[1], 0);
  EXPECT_EQ(page.ink.ink(), 64U);
  EXPECT_EQ(page.info.resolution,
            (Resolution{{204, 1}, {98, 1}, Resolution::Unit::inch}));
}

TEST(JpegReader, AppliesTheExifOrientation) {
  const RasterPage page = read_raster(turned_jpeg(8));  // seen turned left
  ASSERT_EQ(page.ink.width(), 8);
  ASSERT_EQ(page.ink.height(), 16);
  EXPECT_FALSE(page.ink.get(0, 0));
  EXPECT_TRUE(page.ink.get(0, 15));
  EXPECT_EQ(page.info.resolution.x, (Rational{98, 1}));
  EXPECT_TRUE(has_note(page, "orientation 8"));
  EXPECT_FALSE(has_note(read_raster(turned_jpeg(1)), "orientation"));
}

TEST(JpegReader, RejectsTruncationAtEveryByte) {
  for (std::size_t size = 0; size < kJpeg.size(); ++size) {
    EXPECT_NE(error_of({kJpeg.begin(),
                        kJpeg.begin() + static_cast<std::ptrdiff_t>(size)}),
              "no error")
        << size;
  }
}

TEST(JpegReader, RejectsGiantImagesBeforeItAllocates) {
  Bytes file = kJpeg;
  const std::size_t frame = 20 + 69 + 5;  // SOF0's height
  for (std::size_t i = 0; i < 4; i += 2) file[frame + i] = 0xff;
  RasterReadOptions options;
  options.limits.max_pixels = 1 << 30;
  EXPECT_EQ(error_of(file, options).substr(0, 14), "limit_exceeded");
}

}  // namespace
}  // namespace unstep
