#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "formats/tiff_handle.h"
#include "unstep/formats.h"

/// Files for the raster tests, made by libpng and libtiff, not by the code
/// under test.
namespace unstep::test {

using Bytes = std::vector<std::uint8_t>;

/// Runs of random length, so that every coder has something to do.
inline Bitmap random_ink(std::int32_t width, std::int32_t height,
                         std::uint32_t seed) {
  std::mt19937 random(seed);
  Bitmap ink = *Bitmap::create(width, height);
  bool on = false;
  for (std::int32_t y = 0; y < height; ++y) {
    for (std::int32_t x = 0; x < width; ++x) {
      if (random() % 5 == 0) on = !on;
      ink.set(x, y, on);
    }
  }
  return ink;
}

inline Bytes write_raster(RasterFormat format, const Bitmap& ink,
                          const PageInfo& info,
                          std::vector<std::string>* notes = nullptr) {
  RasterWriter writer = *RasterWriter::create(format);
  const Status added = writer.add_page(ink, info, notes);
  EXPECT_TRUE(added) << added.error().message;
  Result<Bytes> file = writer.finish();
  EXPECT_TRUE(file) << file.error().message;
  return file ? *file : Bytes{};
}

inline Result<RasterPage> try_read(Bytes file, RasterReadOptions options = {},
                                   std::size_t page = 0) {
  Result<RasterReader> reader =
      RasterReader::open(std::move(file), std::move(options));
  if (!reader) return reader.error();
  return reader->read(page);
}

inline RasterPage read_raster(Bytes file, RasterReadOptions options = {},
                              std::size_t page = 0) {
  Result<RasterPage> read = try_read(std::move(file), std::move(options), page);
  EXPECT_TRUE(read) << read.error().message;
  return read ? std::move(*read) : RasterPage{};
}

/// "code: message" or "no error".
inline std::string error_of(Bytes file, RasterReadOptions options = {}) {
  const Result<RasterPage> read = try_read(std::move(file), options);
  if (read) return "no error";
  return std::string(to_string(read.error().code)) + ": " +
         read.error().message;
}

inline RasterReadOptions fixed_threshold(int level) {
  RasterReadOptions options;
  options.threshold = {Threshold::Kind::fixed, level};
  return options;
}

inline bool has_note(const RasterPage& page, const std::string& part) {
  for (const std::string& note : page.notes) {
    if (note.find(part) != std::string::npos) return true;
  }
  return false;
}

inline std::string value_of(const PageInfo& info, const std::string& key) {
  for (const auto& [known, value] : info.metadata) {
    if (known == key) return value;
  }
  return "(none)";
}

/// What of the samples of an image: bytes row by row, as the file packs them.
struct PngRecipe {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  int depth = 8;
  int colour_type = PNG_COLOR_TYPE_GRAY;
  bool interlaced = false;
  Bytes rows;
  std::vector<png_color> palette;
  Bytes palette_alpha;
  std::vector<std::pair<std::string, std::string>> texts;
};

inline Bytes make_png(PngRecipe recipe) {
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  Bytes file;
  png_set_write_fn(
      png, &file,
      [](png_structp p, png_bytep data, std::size_t size) {
        auto* out = static_cast<Bytes*>(png_get_io_ptr(p));
        out->insert(out->end(), data, data + size);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, recipe.width, recipe.height, recipe.depth,
               recipe.colour_type,
               recipe.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!recipe.palette.empty()) {
    png_set_PLTE(png, info, recipe.palette.data(),
                 static_cast<int>(recipe.palette.size()));
  }
  if (!recipe.palette_alpha.empty()) {
    png_set_tRNS(png, info, recipe.palette_alpha.data(),
                 static_cast<int>(recipe.palette_alpha.size()), nullptr);
  }
  for (auto& [key, value] : recipe.texts) {
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = key.data();
    text.text = value.data();
    text.text_length = value.size();
    png_set_text(png, info, &text, 1);
  }
  png_write_info(png, info);
  const std::size_t row_bytes = recipe.rows.size() / recipe.height;
  std::vector<png_bytep> rows;
  for (std::size_t y = 0; y < recipe.height; ++y) {
    rows.push_back(recipe.rows.data() + y * row_bytes);
  }
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return file;
}

/// The rows of a bitmap as packed bytes.
inline Bytes packed_rows(const Bitmap& ink, bool invert) {
  const std::size_t row = (static_cast<std::size_t>(ink.width()) + 7) / 8;
  Bytes bytes(row * static_cast<std::size_t>(ink.height()));
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    ink.get_row_bytes(
        y, std::span(bytes).subspan(row * static_cast<std::size_t>(y), row),
        invert);
  }
  return bytes;
}

/// 8-bit rows of `channels` equal samples a pixel.
inline Bytes byte_rows(const Bitmap& ink, std::uint8_t ink_value,
                       std::uint8_t paper_value, std::size_t channels = 1) {
  Bytes bytes;
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    for (std::int32_t x = 0; x < ink.width(); ++x) {
      bytes.insert(bytes.end(), channels,
                   ink.get(x, y) ? ink_value : paper_value);
    }
  }
  return bytes;
}

/// A page of a TIFF file, written by libtiff from packed rows.
struct TiffRecipe {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  int bits = 1;
  int samples = 1;
  int compression = COMPRESSION_NONE;
  int photometric = PHOTOMETRIC_MINISWHITE;
  int orientation = ORIENTATION_TOPLEFT;
  int fill_order = FILLORDER_MSB2LSB;
  int planar = PLANARCONFIG_CONTIG;
  std::uint32_t rows_per_strip = 8;
  std::uint32_t tile = 0;  ///< side; 0: strips
  Bytes rows;
  std::vector<std::pair<std::uint32_t, std::string>> texts;
  std::vector<std::uint16_t> colour_map;  ///< red, green, blue in turn
};

inline void put_tiff_page(TIFF* tiff, const TiffRecipe& recipe) {
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, recipe.width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, recipe.height);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, recipe.bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, recipe.samples);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, recipe.compression);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, recipe.photometric);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, recipe.orientation);
  TIFFSetField(tiff, TIFFTAG_FILLORDER, recipe.fill_order);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, recipe.planar);
  if (!recipe.colour_map.empty()) {
    const std::size_t n = recipe.colour_map.size() / 3;
    const std::uint16_t* map = recipe.colour_map.data();
    TIFFSetField(tiff, TIFFTAG_COLORMAP, map, map + n, map + 2 * n);
  }
  for (const auto& [tag, text] : recipe.texts) {
    TIFFSetField(tiff, tag, text.c_str());
  }
  Bytes rows = recipe.rows;
  const std::size_t row = rows.size() / recipe.height;
  if (recipe.tile == 0) {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, recipe.rows_per_strip);
    for (std::uint32_t y = 0; y < recipe.height; ++y) {
      ASSERT_EQ(TIFFWriteScanline(tiff, rows.data() + y * row, y, 0), 1);
    }
  } else {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, recipe.tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, recipe.tile);
    const auto bits = static_cast<std::size_t>(recipe.bits * recipe.samples);
    const std::size_t tile_row = recipe.tile * bits / 8;
    for (std::uint32_t y = 0; y < recipe.height; y += recipe.tile) {
      for (std::uint32_t x = 0; x < recipe.width; x += recipe.tile) {
        Bytes tile(tile_row * recipe.tile);
        for (std::uint32_t i = 0; i < recipe.tile && y + i < recipe.height;
             ++i) {
          for (std::size_t k = 0; k < tile_row && x * bits / 8 + k < row; ++k) {
            tile[i * tile_row + k] = rows[(y + i) * row + x * bits / 8 + k];
          }
        }
        ASSERT_GT(TIFFWriteTile(tiff, tile.data(), x, y, 0, 0), 0);
      }
    }
  }
  ASSERT_EQ(TIFFWriteDirectory(tiff), 1);
}

inline Bytes make_tiff(const std::vector<TiffRecipe>& pages) {
  TiffOutput output;
  TiffLog log;
  {
    const TiffHandle tiff = open_tiff_output(output, log);
    for (const TiffRecipe& page : pages) put_tiff_page(tiff.get(), page);
  }
  EXPECT_FALSE(log.has_error()) << log.error.data();
  return output.bytes;
}

/// A bilevel page with this ink.
inline TiffRecipe bilevel_recipe(const Bitmap& ink, int compression,
                                 int photometric = PHOTOMETRIC_MINISWHITE) {
  TiffRecipe recipe;
  recipe.width = static_cast<std::uint32_t>(ink.width());
  recipe.height = static_cast<std::uint32_t>(ink.height());
  recipe.compression = compression;
  recipe.photometric = photometric;
  recipe.rows = packed_rows(ink, photometric == PHOTOMETRIC_MINISBLACK);
  return recipe;
}

/// Cuts the file at every byte: an error, or the same picture.
inline void expect_safe_truncation(const Bytes& file,
                                   RasterReadOptions options = {}) {
  const Result<RasterPage> whole = try_read(file, options);
  ASSERT_TRUE(whole) << whole.error().message;
  for (std::size_t size = 0; size < file.size(); ++size) {
    const Result<RasterPage> cut = try_read(
        {file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)},
        options);
    if (cut) {
      EXPECT_EQ(cut->ink, whole->ink) << "cut to " << size;
    } else {
      EXPECT_FALSE(cut.error().message.empty());
      EXPECT_EQ(cut.error().message.find('\n'), std::string::npos);
    }
  }
}

/// Flips every bit; calls `check` with each result that is not an error.
template <class Check>
void flip_every_bit(const Bytes& file, RasterReadOptions options,
                    const Check& check) {
  options.limits.max_pixels = 1 << 20;
  options.limits.max_memory = 16 << 20;
  for (std::size_t bit = 0; bit < file.size() * 8; ++bit) {
    Bytes bad = file;
    bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ 1U << bit % 8);
    const Result<RasterPage> read = try_read(std::move(bad), options);
    if (read) check(bit, *read);
  }
}

}  // namespace unstep::test
