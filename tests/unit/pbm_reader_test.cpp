#include <gtest/gtest.h>

#include "raster_test_support.h"

namespace unstep {
namespace {

using test::Bytes;
using test::packed_rows;

Bytes bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

RasterPage read(std::string_view text, RasterReadOptions options = {}) {
  return test::read_raster(bytes_of(text), options);
}

std::string error_of(std::string_view text) {
  return test::error_of(bytes_of(text));
}

using namespace std::string_view_literals;

TEST(PbmReader, ReadsPlainPbmWithOrWithoutBlanks) {
  for (const std::string_view text :
       {"P1\n3 2\n1 0 1\n0 1 0\n"sv, "P1 3 2 101010"sv,
        "P1#c\n# comment 9\n 3# w\n2\r\n10 1# x\n010"sv}) {
    EXPECT_EQ(packed_rows(read(text).ink, false), (Bytes{0xa0, 0x40}));
  }
}

TEST(PbmReader, ReadsRawPbmAndIgnoresTheUnusedBits) {
  const RasterPage page = read("P4 3 2\n\xbf\x5f"sv);
  EXPECT_EQ(packed_rows(page.ink, false), (Bytes{0xa0, 0x40}));
  EXPECT_EQ(page.ink.ink(), 3U);
}

TEST(PbmReader, ReadsPgmOfTwoValues) {
  for (const std::string_view text :
       {"P2 3 1 255 0 255 0"sv, "P2 3 1 1\n0 1 0\n"sv, "P5 3 1 255\n\0\xff\0"sv,
        "P5 3 1 65535\n\0\0\xff\xff\0\0"sv}) {
    const RasterPage page = read(text);
    EXPECT_EQ(packed_rows(page.ink, false), Bytes{0xa0});
    EXPECT_TRUE(page.lossless);
    EXPECT_TRUE(page.info.metadata.empty());
  }
  EXPECT_EQ(test::value_of(read("P2 2 1 255 17 34").info, "palette"),
            "#111111,#222222");
}

TEST(PbmReader, NeedsAThresholdForMoreThanTwoValues) {
  EXPECT_EQ(error_of("P2 3 1 255 0 1 2").substr(0, 16), "invalid_argument");
  EXPECT_EQ(
      packed_rows(read("P2 3 1 100 0 40 100", test::fixed_threshold(128)).ink,
                  false),
      Bytes{0xc0});
}

TEST(PbmReader, ReadsConcatenatedImages) {
  Result<RasterReader> reader = RasterReader::open(
      bytes_of("P4 8 1\n\x0fP4 8 2\n\xf0\x3cP5 1 1 255\n\0\n"sv), {});
  ASSERT_TRUE(reader) << reader.error().message;
  ASSERT_EQ(reader->page_count(), 3U);
  EXPECT_EQ(packed_rows(reader->read(1)->ink, false), (Bytes{0xf0, 0x3c}));
  EXPECT_EQ(packed_rows(reader->read(0)->ink, false), Bytes{0x0f});
  EXPECT_EQ(reader->read(2)->ink.ink(), 1U);
}

TEST(PbmReader, NamesThePlaceOfErrors) {
  EXPECT_EQ(error_of("P4 8 2\n\x0f"sv),
            "truncated: page 1: the file ends at byte 8 inside the image");
  EXPECT_EQ(error_of("P4 8 1\n\x0fx"sv),
            "corrupt: page 2: byte 8: expected the magic of an image");
  EXPECT_EQ(error_of("P1 2 1 1 2"), "corrupt: page 1: byte 9: expected 0 or 1");
  EXPECT_EQ(error_of("P4 x"), "corrupt: page 1: byte 3: expected a number");
  EXPECT_EQ(error_of("P4 8 99999999999 "),
            "corrupt: page 1: byte 14: number too large");
  EXPECT_EQ(error_of("P2 1 1 70000 0").substr(0, 8), "corrupt:");
  EXPECT_EQ(error_of("P2 1 1 9 10").substr(0, 8), "corrupt:");
  EXPECT_EQ(error_of("P4 0 1\n"),
            "out_of_range: page 1: image of 0 x 1 pixels; sides are 1 to "
            "1073741823");
  EXPECT_EQ(error_of("P6 1 1 255\nabc").substr(0, 12), "unsupported:");
}

TEST(PbmReader, RejectsGiantImagesBeforeItAllocates) {
  EXPECT_EQ(error_of("P4 1000000000 1000000000\n").substr(0, 10), "truncated:");
  EXPECT_EQ(error_of("P4 4294967295 4294967295\n").substr(0, 10), "truncated:");
  EXPECT_EQ(error_of("P1 4294967295 4294967295\n1").substr(0, 10),
            "truncated:");
}

TEST(PbmReader, SurvivesTruncationAndFlippedBits) {
  for (const std::string_view text :
       {"P4 11 2\n\xbf\x5f\x01\x02P4 3 1\n\x80"sv, "P1 3 2 101010\n"sv,
        "P5 3 1 255\n\0\xff\0"sv, "P2 3 1 65535 0 65535 0"sv}) {
    const Bytes file = bytes_of(text);
    for (std::size_t size = 0; size < file.size(); ++size) {
      const Bytes cut(file.begin(),
                      file.begin() + static_cast<std::ptrdiff_t>(size));
      const Result<RasterPage> page = test::try_read(cut);
      // Cut between two images, or in the last number, the rest is a file.
      if (page) {
        EXPECT_EQ(page->ink.width(), read(text).ink.width());
      }
    }
    test::flip_every_bit(file, test::fixed_threshold(128),
                         [](std::size_t, const RasterPage& page) {
                           EXPECT_GT(page.ink.pixels(), 0U);
                         });
  }
}

}  // namespace
}  // namespace unstep
