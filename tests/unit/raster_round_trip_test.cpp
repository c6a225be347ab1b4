#include <gtest/gtest.h>

#include "raster_test_support.h"

namespace unstep {
namespace {

using test::Bytes;
using test::random_ink;
using test::read_raster;
using test::value_of;
using test::write_raster;

constexpr RasterFormat kFormats[] = {RasterFormat::pbm, RasterFormat::png,
                                     RasterFormat::tiff};

TEST(RasterRoundTrip, KeepsThePixelsAtEveryWidth) {
  for (std::int32_t width = 1; width <= 130; ++width) {
    const Bitmap ink = random_ink(width, 1 + width % 7, 7);
    for (const RasterFormat format : kFormats) {
      const RasterPage page = read_raster(write_raster(format, ink, {}));
      EXPECT_EQ(page.ink, ink) << width;
      EXPECT_TRUE(page.lossless);
      EXPECT_TRUE(page.notes.empty()) << page.notes.front();
      EXPECT_EQ(page.info, PageInfo{});
    }
  }
}

TEST(RasterRoundTrip, KeepsAllPaperAndAllInk) {
  for (const bool full : {false, true}) {
    Bitmap ink = *Bitmap::create(67, 3);
    for (std::int32_t y = 0; y < 3; ++y) {
      for (std::int32_t x = 0; x < 67; ++x) ink.set(x, y, full);
    }
    for (const RasterFormat format : kFormats) {
      EXPECT_EQ(read_raster(write_raster(format, ink, {})).ink, ink);
    }
  }
}

TEST(RasterRoundTrip, KeepsPagesInOrder) {
  for (const RasterFormat format : {RasterFormat::pbm, RasterFormat::tiff}) {
    RasterWriter writer = *RasterWriter::create(format);
    constexpr std::size_t kPages = 5;
    for (std::uint32_t i = 0; i < kPages; ++i) {
      PageInfo info;
      info.name = "page " + std::to_string(i);
      info.resolution = {{100 + i, 7}, {200, 1}, Resolution::Unit::inch};
      ASSERT_TRUE(writer.add_page(
          random_ink(20 + static_cast<std::int32_t>(i) * 9, 11, i), info,
          nullptr));
    }
    RasterReader reader = *RasterReader::open(*writer.finish(), {});
    ASSERT_EQ(reader.page_count(), kPages);
    for (const std::uint32_t i : {0U, 1U, 2U, 4U, 3U, 3U, 0U}) {
      const Result<RasterPage> page = reader.read(i);
      ASSERT_TRUE(page) << page.error().message;
      EXPECT_EQ(page->ink,
                random_ink(20 + static_cast<std::int32_t>(i) * 9, 11, i));
      if (format == RasterFormat::tiff) {
        EXPECT_EQ(page->info.name, "page " + std::to_string(i));
        EXPECT_EQ(page->info.resolution.x, (Rational{100 + i, 7}));
      }
    }
    EXPECT_EQ(reader.read(kPages).error().code, ErrorCode::out_of_range);
  }
}

TEST(RasterRoundTrip, TiffKeepsResolutionsExactly) {
  const Bitmap ink = random_ink(9, 9, 1);
  for (const Resolution& resolution :
       {Resolution{{204, 1}, {98, 1}, Resolution::Unit::inch},
        Resolution{{3085, 100}, {385, 10}, Resolution::Unit::centimetre},
        Resolution{{4294967295U, 4294967291U},
                   {1, 4294967295U},
                   Resolution::Unit::inch},
        Resolution{{600, 2}, {600, 2}, Resolution::Unit::none}}) {
    PageInfo info;
    info.resolution = resolution;
    EXPECT_EQ(read_raster(write_raster(RasterFormat::tiff, ink, info)).info,
              info);
  }
}

TEST(RasterRoundTrip, TiffKeepsThePolarityOfEachOfSeveralPages) {
  const Bitmap ink = random_ink(40, 12, 8);
  const auto page = [&ink](int photometric, const char* name) {
    test::TiffRecipe recipe =
        test::bilevel_recipe(ink, COMPRESSION_CCITTFAX4, photometric);
    recipe.texts = {{TIFFTAG_PAGENAME, name}};
    return recipe;
  };
  const Bytes file = test::make_tiff({page(PHOTOMETRIC_MINISBLACK, "front"),
                                      page(PHOTOMETRIC_MINISWHITE, "back")});
  RasterWriter writer = *RasterWriter::create(RasterFormat::tiff);
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < 2; ++i) {
    const RasterPage read = test::read_raster(file, {}, i);
    EXPECT_EQ(read.ink, ink);
    ASSERT_TRUE(writer.add_page(read.ink, read.info, &notes));
  }
  EXPECT_TRUE(notes.empty());
  const Bytes written = *writer.finish();
  for (std::size_t i = 0; i < 2; ++i) {
    const RasterPage first = test::read_raster(file, {}, i);
    const RasterPage again = test::read_raster(written, {}, i);
    EXPECT_EQ(again.ink, ink);
    EXPECT_EQ(again.info, first.info);
    EXPECT_EQ(test::value_of(again.info, "tiff:Photometric"),
              i == 0 ? "MinIsBlack" : "(none)");
    EXPECT_EQ(again.info.name, i == 0 ? "front" : "back");
  }
}

TEST(RasterRoundTrip, TiffTurnsMetresIntoCentimetresExactly) {
  PageInfo info;
  info.resolution = {{11811, 1}, {3937, 1}, Resolution::Unit::metre};
  std::vector<std::string> notes;
  const RasterPage page = read_raster(
      write_raster(RasterFormat::tiff, random_ink(9, 9, 1), info, &notes));
  EXPECT_EQ(
      page.info.resolution,
      (Resolution{{11811, 100}, {3937, 100}, Resolution::Unit::centimetre}));
  EXPECT_TRUE(notes.empty());
}

TEST(RasterRoundTrip, PngKeepsPixelsPerMetreAndRatios) {
  for (const Resolution& resolution :
       {Resolution{{11811, 1}, {3937, 1}, Resolution::Unit::metre},
        Resolution{{2147483647, 1}, {1, 1}, Resolution::Unit::metre},
        Resolution{{4, 1}, {2, 1}, Resolution::Unit::none}}) {
    PageInfo info;
    info.resolution = resolution;
    EXPECT_EQ(
        read_raster(write_raster(RasterFormat::png, random_ink(9, 9, 1), info))
            .info,
        info);
  }
}

TEST(RasterRoundTrip, PngSaysWhenItRoundsAResolution) {
  const auto notes_for = [](const Resolution& resolution) {
    PageInfo info;
    info.resolution = resolution;
    std::vector<std::string> notes;
    write_raster(RasterFormat::png, random_ink(9, 9, 1), info, &notes);
    return notes;
  };
  EXPECT_EQ(notes_for({{204, 1}, {98, 1}, Resolution::Unit::inch}),
            std::vector<std::string>{"PNG rounds the resolution 204 x 98 per "
                                     "inch to 8031 x 3858 per metre"});
  EXPECT_TRUE(notes_for({{254, 1}, {127, 1}, Resolution::Unit::inch}).empty());
  EXPECT_TRUE(
      notes_for({{3085, 100}, {77, 2}, Resolution::Unit::centimetre}).empty());
  EXPECT_EQ(notes_for({{1, 4000}, {1, 1}, Resolution::Unit::metre}),
            std::vector<std::string>{
                "PNG cannot carry the resolution 1/4000 x 1 per metre"});
  EXPECT_EQ(notes_for({{1, 1}, {0, 1}, Resolution::Unit::metre}),
            std::vector<std::string>{
                "PNG cannot carry the resolution 1 x 0 per metre"});
}

TEST(RasterRoundTrip, TiffKeepsItsTextTags) {
  PageInfo info;
  info.name = "Blatt 1";
  info.metadata = {{"tiff:DocumentName", "Plan"},
                   {"tiff:ImageDescription", "line\nline"},
                   {"tiff:Make", "m"},
                   {"tiff:Model", "n"},
                   {"tiff:Software", "s"},
                   {"tiff:DateTime", "2001:02:03 04:05:06"},
                   {"tiff:Artist", "J\xc3\xbcrgen"},
                   {"tiff:HostComputer", "h"},
                   {"tiff:Copyright", "c"}};
  const RasterPage page =
      read_raster(write_raster(RasterFormat::tiff, random_ink(9, 9, 1), info));
  EXPECT_EQ(page.info, info);
  EXPECT_TRUE(page.notes.empty());
}

TEST(RasterRoundTrip, PngKeepsTextOfEveryOrigin) {
  PageInfo info;
  info.name = "Blatt 1";
  info.metadata = {{"tiff:Artist", "J\xc3\xbcrgen"},  // Latin-1
                   {"png:Author", "\xd0\x96"},        // not Latin-1
                   {"png:Comment", ""}};
  std::vector<std::string> notes;
  const RasterPage page = read_raster(
      write_raster(RasterFormat::png, random_ink(9, 9, 1), info, &notes));
  EXPECT_EQ(page.info.name, info.name);
  for (const auto& [key, value] : info.metadata) {
    EXPECT_EQ(value_of(page.info, key), value);
  }
  EXPECT_TRUE(notes.empty());
}

TEST(RasterRoundTrip, WritersSayWhatTheyCannotCarry) {
  PageInfo info;
  info.name = "n";
  info.resolution = {{1, 1}, {1, 1}, Resolution::Unit::inch};
  info.metadata = {{"png:Author", "a"}};
  std::vector<std::string> notes;
  write_raster(RasterFormat::pbm, random_ink(9, 9, 1), info, &notes);
  EXPECT_EQ(notes.size(), 3U);
  notes.clear();
  write_raster(RasterFormat::tiff, random_ink(9, 9, 1), info, &notes);
  EXPECT_EQ(notes, std::vector<std::string>{
                       "TIFF cannot carry the metadata png:Author"});
  notes.clear();
  info.metadata = {{std::string(80, 'k'), "a"}};
  info.resolution = {};
  write_raster(RasterFormat::png, random_ink(9, 9, 1), info, &notes);
  EXPECT_EQ(notes.size(), 1U);
}

TEST(RasterRoundTrip, PaletteReturnsInPngAndTiff) {
  PageInfo info;
  info.metadata = {{"palette", "#112233,#ffeedd"}};
  const Bitmap ink = random_ink(33, 9, 1);
  for (const RasterFormat format : {RasterFormat::png, RasterFormat::tiff}) {
    std::vector<std::string> notes;
    const RasterPage page =
        read_raster(write_raster(format, ink, info, &notes));
    EXPECT_EQ(page.ink, ink);
    EXPECT_EQ(page.info, info);
    EXPECT_TRUE(notes.empty());
  }
  info.metadata = {{"palette", "#111222333444,#ffffff"}};
  EXPECT_EQ(read_raster(write_raster(RasterFormat::tiff, ink, info)).info,
            info);
  std::vector<std::string> notes;
  write_raster(RasterFormat::png, ink, info, &notes);
  EXPECT_EQ(notes.size(), 1U);
}

TEST(RasterWriter, RefusesWhatItCannotDo) {
  RasterWriter png = *RasterWriter::create(RasterFormat::png);
  EXPECT_EQ(png.finish().error().code, ErrorCode::invalid_argument);
  EXPECT_EQ(png.add_page({}, {}, nullptr).error().code,
            ErrorCode::invalid_argument);
  const Bitmap ink = random_ink(9, 9, 1);
  EXPECT_TRUE(png.add_page(ink, {}, nullptr));
  EXPECT_EQ(png.add_page(ink, {}, nullptr).error().code,
            ErrorCode::invalid_argument);
}

TEST(RasterReader, RecognisesFormatsByContent) {
  const Bitmap ink = random_ink(9, 9, 1);
  for (const auto& [format, name] : {std::pair{RasterFormat::pbm, "pbm"},
                                     std::pair{RasterFormat::png, "png"},
                                     std::pair{RasterFormat::tiff, "tiff"}}) {
    EXPECT_EQ(RasterReader::open(write_raster(format, ink, {}), {})->format(),
              name);
  }
  for (const std::string text : {"", "P", "hello", "GIF89a"}) {
    EXPECT_EQ(RasterReader::open({text.begin(), text.end()}, {}).error().code,
              ErrorCode::bad_magic);
  }
  RasterReadOptions options = test::fixed_threshold(256);
  EXPECT_EQ(
      RasterReader::open(write_raster(RasterFormat::pbm, ink, {}), options)
          .error()
          .code,
      ErrorCode::out_of_range);
}

TEST(RasterReader, ChecksLimitsBeforeItReadsPixels) {
  const Bitmap ink = random_ink(100, 100, 1);
  RasterReadOptions few_pixels;
  few_pixels.limits.max_pixels = 9999;
  RasterReadOptions little_memory;
  little_memory.limits.max_memory = 1600;
  for (const RasterFormat format : kFormats) {
    const Bytes file = write_raster(format, ink, {});
    EXPECT_EQ(test::error_of(file, few_pixels),
              "limit_exceeded: page 1: image of 100 x 100 pixels; the limit is "
              "9999 pixels");
    EXPECT_TRUE(test::error_of(file, little_memory).find("memory") !=
                std::string::npos);
  }
}

}  // namespace
}  // namespace unstep
