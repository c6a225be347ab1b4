#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "unstep/formats.h"

namespace unstep {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr RasterFormat kFormats[] = {RasterFormat::pbm, RasterFormat::png,
                                     RasterFormat::tiff};

Bitmap random_ink(std::int32_t width, std::int32_t height, std::uint32_t seed) {
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

Bytes write(RasterFormat format, const Bitmap& ink, const PageInfo& info,
            std::vector<std::string>* notes = nullptr) {
  RasterWriter writer = *RasterWriter::create(format);
  const Status added = writer.add_page(ink, info, notes);
  EXPECT_TRUE(added) << added.error().message;
  return *writer.finish();
}

RasterPage read(const Bytes& file, RasterReadOptions options = {},
                std::size_t page = 0) {
  Result<RasterReader> reader = RasterReader::open(file, options);
  EXPECT_TRUE(reader) << reader.error().message;
  if (!reader) return {};
  Result<RasterPage> read = reader->read(page);
  EXPECT_TRUE(read) << read.error().message;
  return read ? std::move(*read) : RasterPage{};
}

TEST(RasterRoundTrip, KeepsThePixelsAtEveryWidth) {
  for (std::int32_t width = 1; width <= 130; ++width) {
    const Bitmap ink = random_ink(width, 1 + width % 7, 7);
    for (const RasterFormat format : kFormats) {
      const RasterPage page = read(write(format, ink, {}));
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
      EXPECT_EQ(read(write(format, ink, {})).ink, ink);
    }
  }
}

}  // namespace
}  // namespace unstep
