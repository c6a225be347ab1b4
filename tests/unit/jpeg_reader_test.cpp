#include <gtest/gtest.h>

#include <cstdio>
// After cstdio, which it needs.
#include <jpeglib.h>

#include <cstdlib>

#include "raster_test_support.h"

namespace unstep {
namespace {

using test::Bytes;
using test::error_of;
using test::has_note;
using test::read_raster;

struct JpegRecipe {
  std::uint32_t width = 64;
  std::uint32_t height = 48;
  J_COLOR_SPACE space = JCS_GRAYSCALE;
  int components = 1;
  bool progressive = false;
  int restart = 0;  ///< MCUs
  Bytes rows;
};

Bytes make_jpeg(JpegRecipe recipe) {
  jpeg_error_mgr errors{};
  jpeg_compress_struct jpeg{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* out = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &out, &size);
  jpeg.image_width = recipe.width;
  jpeg.image_height = recipe.height;
  jpeg.input_components = recipe.components;
  jpeg.in_color_space = recipe.space;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 95, TRUE);
  jpeg.restart_interval = static_cast<unsigned>(recipe.restart);
  if (recipe.progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  const std::size_t row = recipe.rows.size() / recipe.height;
  while (jpeg.next_scanline < recipe.height) {
    JSAMPROW line = recipe.rows.data() + row * jpeg.next_scanline;
    jpeg_write_scanlines(&jpeg, &line, 1);
  }
  jpeg_finish_compress(&jpeg);
  Bytes file(out, out + size);
  std::free(out);
  jpeg_destroy_compress(&jpeg);
  return file;
}

/// A dark square on light, every pixel of `dark` or `light` samples.
JpegRecipe square(J_COLOR_SPACE space, const Bytes& dark, const Bytes& light) {
  JpegRecipe recipe;
  recipe.space = space;
  recipe.components = static_cast<int>(dark.size());
  for (std::uint32_t y = 0; y < recipe.height; ++y) {
    for (std::uint32_t x = 0; x < recipe.width; ++x) {
      const bool ink = x >= 16 && x < 48 && y >= 16 && y < 32;
      const Bytes& pixel = ink ? dark : light;
      recipe.rows.insert(recipe.rows.end(), pixel.begin(), pixel.end());
    }
  }
  return recipe;
}

void expect_square(const RasterPage& page) {
  ASSERT_EQ(page.ink.width(), 64);
  ASSERT_EQ(page.ink.height(), 48);
  EXPECT_EQ(page.ink.ink(), 32U * 16U);
  EXPECT_TRUE(page.ink.get(16, 16));
  EXPECT_TRUE(page.ink.get(47, 31));
}

TEST(JpegReader, ReadsGreyColourAndInk) {
  const RasterReadOptions options = test::fixed_threshold(128);
  expect_square(
      read_raster(make_jpeg(square(JCS_GRAYSCALE, {20}, {240})), options));
  expect_square(read_raster(
      make_jpeg(square(JCS_RGB, {90, 20, 30}, {250, 240, 200})), options));
  // CMYK as libjpeg writes it: plain, with an Adobe marker, so 255 is no ink.
  const RasterPage page = read_raster(
      make_jpeg(square(JCS_CMYK, {255, 255, 255, 30}, {255, 255, 250, 255})),
      options);
  expect_square(page);
  EXPECT_TRUE(has_note(page, "CMYK shown"));
}

TEST(JpegReader, ReadsProgressiveFilesAndRestarts) {
  JpegRecipe recipe = square(JCS_GRAYSCALE, {20}, {240});
  recipe.progressive = true;
  expect_square(read_raster(make_jpeg(recipe), test::fixed_threshold(128)));
  recipe.progressive = false;
  recipe.restart = 3;
  expect_square(read_raster(make_jpeg(recipe), test::fixed_threshold(128)));
}

TEST(JpegReader, NoticesDamageInsideTheCodedData) {
  JpegRecipe recipe;
  std::mt19937 random(3);
  for (std::uint32_t i = 0; i < recipe.width * recipe.height; ++i) {
    recipe.rows.push_back(static_cast<std::uint8_t>(random() % 256));
  }
  const Bytes file = make_jpeg(recipe);
  // The middle third of the coded data is missing, but not the end marker.
  Bytes cut(file.begin(),
            file.begin() + static_cast<std::ptrdiff_t>(file.size() / 3));
  cut.insert(cut.end(),
             file.begin() + static_cast<std::ptrdiff_t>(file.size() * 2 / 3),
             file.end());
  EXPECT_EQ(error_of(cut, test::fixed_threshold(128)).substr(0, 25),
            "corrupt: page 1: libjpeg:");
  // A changed bit makes other codes, often as many as there should be.
  int noticed = 0;
  int tried = 0;
  for (std::size_t at = file.size() / 2; at < file.size() - 2; at += 13) {
    Bytes bad = file;
    bad[at] ^= 4;
    ++tried;
    if (error_of(bad, test::fixed_threshold(128)) != "no error") ++noticed;
  }
  EXPECT_GT(noticed * 3, tried) << noticed << " of " << tried;
}

TEST(JpegReader, SurvivesTruncationAndFlippedBits) {
  for (const bool progressive : {false, true}) {
    JpegRecipe recipe = square(JCS_RGB, {90, 20, 30}, {250, 240, 200});
    recipe.progressive = progressive;
    const Bytes file = make_jpeg(recipe);
    for (std::size_t size = 0; size < file.size(); size += 3) {
      EXPECT_NE(error_of({file.begin(),
                          file.begin() + static_cast<std::ptrdiff_t>(size)},
                         test::fixed_threshold(128)),
                "no error");
    }
    RasterReadOptions options = test::fixed_threshold(128);
    options.limits.max_pixels = 1 << 16;
    options.limits.max_memory = 16 << 20;
    for (std::size_t bit = 0; bit < file.size() * 8; bit += 7) {
      Bytes bad = file;
      bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ 1U << bit % 8);
      EXPECT_EQ(error_of(bad, options).find('\n'), std::string::npos);
    }
  }
}

TEST(JpegReader, RefusesTooManyScans) {
  JpegRecipe recipe = square(JCS_GRAYSCALE, {20}, {240});
  recipe.progressive = true;
  const Bytes file = make_jpeg(recipe);
  // The last scan again and again.
  std::size_t last = file.size() - 2;
  while (!(file[last] == 0xff && file[last + 1] == 0xda)) --last;
  Bytes bomb(file.begin(), file.end() - 2);
  for (int i = 0; i < 600; ++i) {
    bomb.insert(bomb.end(), file.begin() + static_cast<std::ptrdiff_t>(last),
                file.end() - 2);
  }
  bomb.insert(bomb.end(), {0xff, 0xd9});
  EXPECT_NE(error_of(bomb, test::fixed_threshold(128)), "no error");
}

}  // namespace
}  // namespace unstep
