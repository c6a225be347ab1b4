#include <gtest/gtest.h>
#include <zlib.h>

#include "raster_test_support.h"

namespace unstep {
namespace {

using test::Bytes;
using test::error_of;
using test::has_note;
using test::make_png;
using test::packed_rows;
using test::PngRecipe;
using test::random_ink;
using test::read_raster;
using test::value_of;

PngRecipe one_bit(const Bitmap& ink) {
  PngRecipe recipe;
  recipe.width = static_cast<std::uint32_t>(ink.width());
  recipe.height = static_cast<std::uint32_t>(ink.height());
  recipe.depth = 1;
  recipe.rows = packed_rows(ink, true);
  return recipe;
}

TEST(PngReader, ReadsInterlacedBilevelImages) {
  for (const std::int32_t width : {1, 2, 3, 5, 8, 9, 63, 64, 65, 130}) {
    for (const std::int32_t height : {1, 2, 5, 17}) {
      const Bitmap ink = random_ink(width, height, 4);
      PngRecipe recipe = one_bit(ink);
      recipe.interlaced = true;
      EXPECT_EQ(read_raster(make_png(recipe)).ink, ink);
    }
  }
}

TEST(PngReader, TakesTheDarkerPaletteEntryAsInk) {
  const Bitmap ink = random_ink(37, 5, 4);
  PngRecipe recipe = one_bit(ink);
  recipe.colour_type = PNG_COLOR_TYPE_PALETTE;
  recipe.palette = {{0x11, 0x22, 0x33}, {0xff, 0xff, 0xff}};
  RasterPage page = read_raster(make_png(recipe));
  EXPECT_EQ(page.ink, ink);
  EXPECT_EQ(value_of(page.info, "palette"), "#112233,#ffffff");
  recipe.palette = {{0xff, 0xff, 0xff}, {0, 0, 0}};
  recipe.rows = packed_rows(ink, false);
  page = read_raster(make_png(recipe));
  EXPECT_EQ(page.ink, ink);
  EXPECT_TRUE(page.info.metadata.empty());
}

TEST(PngReader, ShowsTransparencyOverWhite) {
  const Bitmap ink = random_ink(37, 5, 4);
  PngRecipe recipe = one_bit(ink);
  recipe.colour_type = PNG_COLOR_TYPE_PALETTE;
  recipe.palette = {{0, 0, 0}, {0, 0, 0}};
  recipe.palette_alpha = {255, 0};
  RasterPage page = read_raster(make_png(recipe));
  EXPECT_EQ(page.ink, ink);
  EXPECT_TRUE(page.info.metadata.empty());
  EXPECT_TRUE(has_note(page, "over white"));

  PngRecipe rgba;
  rgba.width = 2;
  rgba.height = 1;
  rgba.colour_type = PNG_COLOR_TYPE_RGB_ALPHA;
  rgba.rows = {0, 0, 0, 255, 0, 0, 0, 0};
  page = read_raster(make_png(rgba));
  EXPECT_EQ(packed_rows(page.ink, false), Bytes{0x80});
  EXPECT_TRUE(has_note(page, "over white"));
}

TEST(PngReader, TakesTwoValuesOfAnyKindAsBilevel) {
  const Bitmap ink = random_ink(37, 11, 4);
  for (const bool interlaced : {false, true}) {
    for (const auto& [type, channels] :
         {std::pair{PNG_COLOR_TYPE_GRAY, 1U}, {PNG_COLOR_TYPE_RGB, 3U}}) {
      for (const int depth : {8, 16}) {
        PngRecipe recipe = one_bit(ink);
        recipe.depth = depth;
        recipe.colour_type = type;
        recipe.interlaced = interlaced;
        const std::size_t bytes = channels * static_cast<unsigned>(depth) / 8;
        recipe.rows = test::byte_rows(ink, 0x20, 0xff, bytes);
        const RasterPage page = read_raster(make_png(recipe));
        EXPECT_EQ(page.ink, ink);
        EXPECT_TRUE(page.lossless);
        EXPECT_EQ(value_of(page.info, "palette"), "#202020,#ffffff");
      }
    }
  }
}

TEST(PngReader, ReadsTwoAndFourBitSamples) {
  PngRecipe recipe;
  recipe.width = 4;
  recipe.depth = 2;
  recipe.rows = {0x33};
  EXPECT_EQ(packed_rows(read_raster(make_png(recipe)).ink, false), Bytes{0xa0});
  recipe.depth = 4;
  recipe.rows = {0x0f, 0xf0};
  EXPECT_EQ(packed_rows(read_raster(make_png(recipe)).ink, false), Bytes{0x90});
}

TEST(PngReader, DistinguishesSixteenBitValuesThatLookAlike) {
  PngRecipe recipe;
  recipe.width = 3;
  recipe.depth = 16;
  recipe.rows = {0, 0, 0, 1, 0xff, 0xff};
  EXPECT_EQ(error_of(make_png(recipe)).substr(0, 16), "invalid_argument");
}

TEST(PngReader, DecidesAnImageOfOneValueByItsLuminance) {
  for (const auto& [value, is_ink] :
       {std::pair{0, true}, {127, true}, {128, false}, {255, false}}) {
    PngRecipe recipe;
    recipe.width = 3;
    recipe.rows = Bytes(3, static_cast<std::uint8_t>(value));
    const RasterPage page = read_raster(make_png(recipe));
    EXPECT_EQ(page.ink.ink(), is_ink ? 3U : 0U);
    EXPECT_EQ(has_note(page, "every pixel"), value == 127 || value == 128);
  }
}

TEST(PngReader, ThresholdsWhenAskedTo) {
  PngRecipe recipe;
  recipe.width = 8;
  recipe.rows = {0, 10, 20, 100, 101, 230, 240, 250};
  const Bytes file = make_png(recipe);
  EXPECT_EQ(error_of(file).substr(0, 16), "invalid_argument");
  RasterPage page = read_raster(file, test::fixed_threshold(101));
  EXPECT_EQ(packed_rows(page.ink, false), Bytes{0xf0});
  EXPECT_FALSE(page.lossless);
  RasterReadOptions otsu;
  otsu.threshold.kind = Threshold::Kind::otsu;
  page = read_raster(file, otsu);
  EXPECT_EQ(packed_rows(page.ink, false), Bytes{0xf8});
  EXPECT_TRUE(has_note(page, "(otsu)"));
  // Two values need no threshold, and none is used.
  recipe.rows = {200, 200, 255, 255, 200, 200, 255, 255};
  page = read_raster(make_png(recipe), test::fixed_threshold(101));
  EXPECT_EQ(packed_rows(page.ink, false), Bytes{0xcc});
  EXPECT_TRUE(page.lossless);
  EXPECT_TRUE(has_note(page, "not used"));
  page = read_raster(make_png(recipe), test::fixed_threshold(201));
  EXPECT_TRUE(page.lossless);
  EXPECT_FALSE(has_note(page, "not used"));
}

TEST(PngReader, WeighsColoursByRec601) {
  PngRecipe recipe;
  recipe.width = 3;
  recipe.colour_type = PNG_COLOR_TYPE_RGB;
  recipe.rows = {255, 0, 0, 0, 255, 0, 0, 0, 255};  // 76, 150, 29
  const Bytes file = make_png(recipe);
  for (const auto& [level, bits] : {std::pair{29, 0x00},
                                    {30, 0x20},
                                    {76, 0x20},
                                    {77, 0xa0},
                                    {150, 0xa0},
                                    {151, 0xe0}}) {
    EXPECT_EQ(
        packed_rows(read_raster(file, test::fixed_threshold(level)).ink, false),
        Bytes{static_cast<std::uint8_t>(bits)})
        << level;
  }
}

TEST(PngReader, KeepsTextAndJoinsRepeatedKeys) {
  PngRecipe recipe = one_bit(random_ink(9, 2, 4));
  recipe.texts = {{"Author", "J\xfcrgen"}, {"Note", "one"}, {"Note", "two"}};
  const RasterPage page = read_raster(make_png(recipe));
  EXPECT_EQ(value_of(page.info, "png:Author"), "J\xc3\xbcrgen");
  EXPECT_EQ(value_of(page.info, "png:Note"), "one\ntwo");
}

TEST(PngReader, RejectsTruncationAtEveryByteAndEveryFlippedBit) {
  const Bitmap ink = random_ink(20, 6, 4);
  PngRecipe interlaced = one_bit(ink);
  interlaced.interlaced = true;
  interlaced.texts = {{"Author", "a"}};
  PngRecipe grey = one_bit(ink);
  grey.depth = 8;
  grey.rows = test::byte_rows(ink, 3, 250);
  for (const PngRecipe& recipe : {one_bit(ink), interlaced, grey}) {
    const Bytes file = make_png(recipe);
    for (std::size_t size = 0; size < file.size(); ++size) {
      const Bytes cut(file.begin(),
                      file.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_NE(error_of(cut), "no error") << size;
    }
    test::flip_every_bit(file, {}, [](std::size_t bit, const RasterPage&) {
      ADD_FAILURE() << "bit " << bit;
    });
  }
}

/// A chunk with its length and CRC.
void put_chunk(Bytes& file, const std::string& type, const Bytes& body) {
  const auto put = [&file](std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      file.push_back(static_cast<std::uint8_t>(value >> shift));
    }
  };
  put(static_cast<std::uint32_t>(body.size()));
  Bytes checked(type.begin(), type.end());
  checked.insert(checked.end(), body.begin(), body.end());
  file.insert(file.end(), checked.begin(), checked.end());
  put(static_cast<std::uint32_t>(
      crc32(0, checked.data(), static_cast<uInt>(checked.size()))));
}

TEST(PngReader, RejectsGiantImagesBeforeItAllocates) {
  for (const std::uint8_t depth : {std::uint8_t{1}, std::uint8_t{8}}) {
    Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    put_chunk(
        file, "IHDR",
        {0x3f, 0xff, 0xff, 0xff, 0x3f, 0xff, 0xff, 0xff, depth, 0, 0, 0, 0});
    put_chunk(file, "IDAT", {0x78, 0x9c, 0x63, 0, 0, 0, 1, 0, 1});
    EXPECT_EQ(error_of(file).substr(0, 14), "limit_exceeded");
  }
}

TEST(PngReader, NeverMakesUpMissingRows) {
  Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  put_chunk(file, "IHDR", {0, 0, 0, 8, 0, 0, 0, 9, 1, 0, 0, 0, 0});
  Bytes rows(2 * 3), packed(100);  // three of the nine rows
  uLongf size = packed.size();
  ASSERT_EQ(compress(packed.data(), &size, rows.data(), rows.size()), Z_OK);
  packed.resize(size);
  put_chunk(file, "IDAT", packed);
  put_chunk(file, "IEND", {});
  EXPECT_EQ(error_of(file).substr(0, 8), "corrupt:");
}

TEST(PngReader, RefusesTextThatInflatesBeyondReason) {
  const Bytes good = make_png(one_bit(random_ink(9, 2, 4)));
  Bytes text(8 << 20, 'a'), packed(1 << 20);
  uLongf size = packed.size();
  ASSERT_EQ(compress(packed.data(), &size, text.data(), text.size()), Z_OK);
  Bytes body{'K', 0, 0};
  body.insert(body.end(), packed.begin(),
              packed.begin() + static_cast<std::ptrdiff_t>(size));
  Bytes file(good.begin(), good.begin() + 33);  // signature and IHDR
  put_chunk(file, "zTXt", body);
  file.insert(file.end(), good.begin() + 33, good.end());
  const Result<RasterPage> page = test::try_read(file);
  ASSERT_TRUE(page) << page.error().message;
  EXPECT_EQ(value_of(page->info, "png:K"), "(none)");
  EXPECT_TRUE(has_note(*page, "libpng"));
}

TEST(PngReader, NotesWhatFollowsTheImage) {
  Bytes file = make_png(one_bit(random_ink(9, 2, 4)));
  file.insert(file.end(), {1, 2, 3});
  EXPECT_TRUE(has_note(read_raster(file), "3 bytes after the image"));
}

}  // namespace
}  // namespace unstep
