#include <gtest/gtest.h>

#include <algorithm>

#include "raster_test_support.h"

namespace unstep {
namespace {

using test::bilevel_recipe;
using test::Bytes;
using test::error_of;
using test::has_note;
using test::make_tiff;
using test::random_ink;
using test::read_raster;
using test::TiffRecipe;

constexpr int kCompressions[] = {
    COMPRESSION_NONE,      COMPRESSION_CCITTRLE,     COMPRESSION_CCITTFAX3,
    COMPRESSION_CCITTFAX4, COMPRESSION_LZW,          COMPRESSION_PACKBITS,
    COMPRESSION_DEFLATE,   COMPRESSION_ADOBE_DEFLATE};

TEST(TiffReader, ReadsEveryCompressionPolarityAndBitOrder) {
  for (const int compression : kCompressions) {
    for (const int photometric :
         {PHOTOMETRIC_MINISWHITE, PHOTOMETRIC_MINISBLACK}) {
      for (const int order : {FILLORDER_MSB2LSB, FILLORDER_LSB2MSB}) {
        for (const std::int32_t width : {1, 8, 63, 64, 65, 130}) {
          const Bitmap ink = random_ink(width, 21, 5);
          TiffRecipe recipe = bilevel_recipe(ink, compression, photometric);
          recipe.fill_order = order;
          const RasterPage page = read_raster(make_tiff({recipe}));
          EXPECT_EQ(page.ink, ink) << compression << " " << photometric << " "
                                   << order << " " << width;
          EXPECT_TRUE(page.lossless);
          EXPECT_TRUE(page.info.metadata.empty());
        }
      }
    }
  }
}

TEST(TiffReader, ReadsTiles) {
  for (const int compression :
       {COMPRESSION_NONE, COMPRESSION_CCITTFAX4, COMPRESSION_LZW}) {
    for (const std::int32_t side : {1, 15, 16, 17, 40, 64, 70}) {
      const Bitmap ink = random_ink(side, 71 - side, 5);
      TiffRecipe recipe = bilevel_recipe(ink, compression);
      recipe.tile = 16;
      EXPECT_EQ(read_raster(make_tiff({recipe})).ink, ink) << side;
    }
  }
}

/// The pixel of the stored image that is seen at (x, y), by TIFF 6.0 page 36.
bool seen_at(const Bitmap& stored, int orientation, std::int32_t x,
             std::int32_t y) {
  const std::int32_t w = stored.width() - 1;
  const std::int32_t h = stored.height() - 1;
  switch (orientation) {
    case 2: return stored.get(w - x, y);
    case 3: return stored.get(w - x, h - y);
    case 4: return stored.get(x, h - y);
    case 5: return stored.get(y, x);
    case 6: return stored.get(y, h - x);
    case 7: return stored.get(w - y, h - x);
    case 8: return stored.get(w - y, x);
    default: return stored.get(x, y);
  }
}

TEST(TiffReader, AppliesEveryOrientation) {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    for (const auto& [width, height] :
         {std::pair{1, 1}, {5, 3}, {64, 2}, {65, 130}, {130, 65}}) {
      const Bitmap ink = random_ink(width, height, 9);
      TiffRecipe recipe = bilevel_recipe(ink, COMPRESSION_CCITTFAX4);
      recipe.orientation = orientation;
      const RasterPage page = read_raster(make_tiff({recipe}));
      ASSERT_EQ(page.ink.width(), orientation >= 5 ? height : width);
      ASSERT_EQ(page.ink.height(), orientation >= 5 ? width : height);
      for (std::int32_t y = 0; y < page.ink.height(); ++y) {
        for (std::int32_t x = 0; x < page.ink.width(); ++x) {
          ASSERT_EQ(page.ink.get(x, y), seen_at(ink, orientation, x, y))
              << orientation << ": " << x << " " << y;
        }
        ASSERT_EQ(page.ink.row(y).back() & ~page.ink.last_word_mask(), 0U);
      }
      EXPECT_EQ(has_note(page, "orientation"), orientation != 1);
    }
  }
}

/// A file built by hand: one strip of one row of 8 pixels.
struct HandMade {
  bool little = true;
  bool big_tiff = false;
  std::uint32_t width = 8;
  std::uint32_t height = 1;
  int orientation = 1;

  [[nodiscard]] Bytes build() const {
    Bytes file;
    put(file, little ? 0x4949 : 0x4d4d, 2);
    put(file, big_tiff ? 43 : 42, 2);
    if (big_tiff) {
      put(file, 8, 2);
      put(file, 0, 2);
    }
    const std::size_t field = big_tiff ? 8 : 4;
    put(file, file.size() + field + 8 * 3, field);
    const std::size_t values = file.size();
    for (const std::uint32_t part : {204U, 1U, 3855U, 39U}) put(file, part, 4);
    file.insert(file.end(), {0xa5, 0, 0, 0, 0, 0, 0, 0});
    put(file, 11, big_tiff ? 8 : 2);
    const auto entry = [&](unsigned tag, unsigned type, std::uint64_t value) {
      put(file, tag, 2);
      put(file, type, 2);
      put(file, 1, field);
      const std::size_t size = type == 3 ? 2 : type == 4 ? 4 : field;
      if (type == 5 && big_tiff) {  // the value itself fits
        file.insert(file.end(),
                    file.begin() + static_cast<std::ptrdiff_t>(value),
                    file.begin() + static_cast<std::ptrdiff_t>(value) + 8);
        return;
      }
      put(file, value, size);
      file.insert(file.end(), field - size, 0);
    };
    entry(256, 4, width);
    entry(257, 4, height);
    entry(258, 3, 1);
    entry(259, 3, 1);
    entry(262, 3, 0);
    entry(273, 4, values + 16);
    entry(274, 3, static_cast<std::uint64_t>(orientation));
    entry(278, 4, height);
    entry(279, 4, 1);
    entry(282, 5, values);
    entry(283, 5, values + 8);
    put(file, 0, field);
    return file;
  }

 private:
  void put(Bytes& file, std::uint64_t value, std::size_t size) const {
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t shift = (little ? i : size - 1 - i) * 8;
      file.push_back(static_cast<std::uint8_t>(value >> shift));
    }
  }
};

TEST(TiffReader, ReadsBothByteOrdersAndBigTiffWithExactResolutions) {
  for (const bool little : {true, false}) {
    for (const bool big_tiff : {true, false}) {
      HandMade hand;
      hand.little = little;
      hand.big_tiff = big_tiff;
      const RasterPage page = read_raster(hand.build());
      EXPECT_EQ(test::packed_rows(page.ink, false), Bytes{0xa5});
      EXPECT_EQ(page.info.resolution,
                (Resolution{{204, 1}, {3855, 39}, Resolution::Unit::inch}));
    }
  }
}

TEST(TiffReader, ExchangesTheResolutionsOfATurnedPage) {
  HandMade hand;
  hand.orientation = 6;
  EXPECT_EQ(read_raster(hand.build()).info.resolution,
            (Resolution{{3855, 39}, {204, 1}, Resolution::Unit::inch}));
}

TEST(TiffReader, RejectsGiantImagesBeforeItAllocates) {
  HandMade hand;
  hand.width = 1000000000;
  hand.height = 1000000000;
  EXPECT_EQ(error_of(hand.build()).substr(0, 15), "limit_exceeded:");
  hand.width = 0x80000000U;
  hand.height = 1;
  EXPECT_NE(error_of(hand.build()), "no error");
}

TEST(TiffReader, NeverMakesUpMissingRows) {
  HandMade hand;
  hand.height = 3;  // three rows announced, one there
  EXPECT_NE(error_of(hand.build()), "no error");
}

TEST(TiffReader, TakesTwoValuesOfAnyKindAsBilevel) {
  const Bitmap ink = random_ink(37, 11, 5);
  TiffRecipe grey;
  grey.width = 37;
  grey.height = 11;
  grey.bits = 8;
  grey.photometric = PHOTOMETRIC_MINISBLACK;
  grey.rows = test::byte_rows(ink, 0, 255);
  EXPECT_EQ(read_raster(make_tiff({grey})).ink, ink);

  TiffRecipe inverse = grey;
  inverse.photometric = PHOTOMETRIC_MINISWHITE;
  inverse.rows = test::byte_rows(ink, 255, 0);
  EXPECT_EQ(read_raster(make_tiff({inverse})).ink, ink);

  TiffRecipe rgb = grey;
  rgb.samples = 3;
  rgb.photometric = PHOTOMETRIC_RGB;
  rgb.compression = COMPRESSION_LZW;
  rgb.rows = test::byte_rows(ink, 0x20, 0xc0, 3);
  const RasterPage coloured = read_raster(make_tiff({rgb}));
  EXPECT_EQ(coloured.ink, ink);
  EXPECT_TRUE(coloured.lossless);
  EXPECT_EQ(test::value_of(coloured.info, "palette"), "#202020,#c0c0c0");

  TiffRecipe tiled = rgb;
  tiled.tile = 16;
  EXPECT_EQ(read_raster(make_tiff({tiled})).ink, ink);
}

TEST(TiffReader, ReadsSmallAndWideSamples) {
  // 2 bits: 3 is ink of a min-is-white page; 0b11001100 is ink, paper, ...
  TiffRecipe two;
  two.width = 4;
  two.height = 1;
  two.bits = 2;
  two.rows = {0xcc};
  EXPECT_EQ(test::packed_rows(read_raster(make_tiff({two})).ink, false),
            Bytes{0xa0});
  TiffRecipe four = two;
  four.bits = 4;
  four.rows = {0xf0, 0x0f};
  EXPECT_EQ(test::packed_rows(read_raster(make_tiff({four})).ink, false),
            Bytes{0x90});
  TiffRecipe sixteen = two;
  sixteen.bits = 16;
  sixteen.photometric = PHOTOMETRIC_MINISBLACK;
  sixteen.rows = {0x34, 0x12, 0xff, 0xff, 0x34, 0x12, 0xff, 0xff};
  const RasterPage page = read_raster(make_tiff({sixteen}));
  EXPECT_EQ(test::packed_rows(page.ink, false), Bytes{0xa0});
  EXPECT_EQ(test::value_of(page.info, "palette"), "#123412341234,#ffffff");
}

TEST(TiffReader, ReadsPalettesAndSeparatePlanes) {
  TiffRecipe palette;
  palette.width = 8;
  palette.height = 1;
  palette.photometric = PHOTOMETRIC_PALETTE;
  palette.colour_map = {0xffff, 0x1111, 0xffff, 0x2222, 0xffff, 0x3333};
  palette.rows = {0xa5};
  const RasterPage page = read_raster(make_tiff({palette}));
  EXPECT_EQ(test::packed_rows(page.ink, false), Bytes{0xa5});
  EXPECT_EQ(test::value_of(page.info, "palette"), "#112233,#ffffff");
}

TEST(TiffReader, NeedsAThresholdForMoreThanTwoValues) {
  TiffRecipe grey;
  grey.width = 8;
  grey.height = 1;
  grey.bits = 8;
  grey.photometric = PHOTOMETRIC_MINISBLACK;
  grey.rows = {0, 10, 100, 127, 128, 200, 255, 255};
  const Bytes file = make_tiff({grey});
  EXPECT_EQ(error_of(file),
            "invalid_argument: page 1: more than two pixel values; give "
            "--threshold auto, a level or another method to make it "
            "bilevel (not lossless)");
  const RasterPage page = read_raster(file, test::fixed_threshold(128));
  EXPECT_EQ(test::packed_rows(page.ink, false), Bytes{0xf0});
  EXPECT_FALSE(page.lossless);
  EXPECT_TRUE(has_note(page, "below 128"));
}

TEST(TiffReader, KeepsTextTagsAndNamesOtherTags) {
  TiffRecipe recipe = bilevel_recipe(random_ink(8, 8, 1), COMPRESSION_NONE);
  recipe.texts = {{TIFFTAG_ARTIST, "J\xfcrgen"},  // Latin-1
                  {TIFFTAG_PAGENAME, "3a"},
                  {TIFFTAG_DOCUMENTNAME, "\xd0\x96"}};
  const RasterPage page = read_raster(make_tiff({recipe}));
  EXPECT_EQ(page.info.name, "3a");
  EXPECT_EQ(test::value_of(page.info, "tiff:Artist"), "J\xc3\xbcrgen");
  EXPECT_EQ(test::value_of(page.info, "tiff:DocumentName"), "\xd0\x96");
}

TEST(TiffReader, TellsOfDamagedFaxLines) {
  const Bitmap ink = random_ink(200, 40, 5);
  for (const int compression : {COMPRESSION_CCITTFAX3, COMPRESSION_CCITTFAX4}) {
    TiffRecipe recipe = bilevel_recipe(ink, compression);
    recipe.rows_per_strip = 40;
    const Bytes good = make_tiff({recipe});
    // Code words begin after the header; a burst of zeros fits no code.
    Bytes bad = good;
    for (std::size_t i = 0; i < 8; ++i) bad.at(8 + 60 + i) = 0;
    EXPECT_EQ(error_of(bad).substr(0, 8), "corrupt:") << compression;
  }
}

TEST(TiffReader, SurvivesTruncationAtEveryByte) {
  const Bitmap ink = random_ink(30, 10, 5);
  for (const int compression : kCompressions) {
    test::expect_safe_truncation(make_tiff({bilevel_recipe(ink, compression)}));
  }
  TiffRecipe tiled = bilevel_recipe(ink, COMPRESSION_LZW);
  tiled.tile = 16;
  test::expect_safe_truncation(make_tiff({tiled}));
}

TEST(TiffReader, SurvivesEveryFlippedBit) {
  const Bitmap ink = random_ink(20, 6, 5);
  for (const int compression : kCompressions) {
    TiffRecipe recipe = bilevel_recipe(ink, compression);
    recipe.texts = {{TIFFTAG_ARTIST, "somebody"}};
    test::flip_every_bit(make_tiff({recipe}), test::fixed_threshold(128),
                         [](std::size_t, const RasterPage& page) {
                           EXPECT_GT(page.ink.pixels(), 0U);
                         });
  }
  TiffRecipe tiled = bilevel_recipe(ink, COMPRESSION_DEFLATE);
  tiled.tile = 16;
  test::flip_every_bit(make_tiff({tiled}), test::fixed_threshold(128),
                       [](std::size_t, const RasterPage&) {});
}

TEST(TiffReader, ReportsABrokenChainOfPages) {
  const TiffRecipe page = bilevel_recipe(random_ink(20, 6, 5), COMPRESSION_LZW);
  const Bytes good = make_tiff({page, page});
  Result<RasterReader> reader = RasterReader::open(good, {});
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->page_count(), 2U);
  const Bytes cut(good.begin(), good.end() - 20);
  EXPECT_NE(error_of(cut), "no error");
}

}  // namespace
}  // namespace unstep
