#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "codec/block_coder.h"
#include "codec/contour_coder.h"
#include "codec/pixel_coder.h"
#include "unit/container_testing.h"
#include "unstep/formats.h"

namespace unstep {
namespace {

std::size_t file_size(const Page& page, Effort effort) {
  EncodeOptions options;
  options.effort = effort;
  UstpWriter writer(options);
  EXPECT_TRUE(writer.add_page(page.ink, page.info));
  return writer.finish()->size();
}

/// Strokes straight down, up to `tall`, none like another, `gap` pixels apart.
Bitmap upright_strokes(std::int32_t width, std::int32_t height,
                       std::uint32_t gap, std::int32_t tall) {
  Bitmap ink = *Bitmap::create(width, height);
  std::mt19937 random(1);
  for (std::int32_t y = 0; y + tall < height; y += tall + 4) {
    for (std::int32_t x = 4; x + 64 < width;) {
      const auto breadth = static_cast<std::int32_t>(3 + random() % 5);
      const auto length = tall / 2 + static_cast<std::int32_t>(random() % 30);
      for (std::int32_t v = y; v < y + length; ++v) {
        const std::int32_t left = x + static_cast<std::int32_t>(random() % 2);
        for (std::int32_t u = left; u < x + breadth; ++u) ink.set(u, v, true);
      }
      x += breadth + static_cast<std::int32_t>(gap + random() % gap);
    }
  }
  return ink;
}

/// Two of three tiles of 5 x 5 pixels are ink, nearly all of it in one piece.
Bitmap tiles(std::int32_t side) {
  Bitmap ink = *Bitmap::create(side, side);
  std::mt19937 random(2);
  for (std::int32_t y = 0; y + 5 <= side; y += 5) {
    for (std::int32_t x = 0; x + 5 <= side; x += 5) {
      if (random() % 3 == 0) continue;
      for (std::int32_t i = 0; i < 25; ++i) ink.set(x + i % 5, y + i / 5, true);
    }
  }
  return ink;
}

codec::CoderName coder_of(const Bitmap& ink) {
  const Result<codec::EncodedBlock> block =
      codec::encode_ink(ink, 0, ink.height(), Effort::standard, {});
  EXPECT_TRUE(block);
  return block->name;
}

auto of(std::uint8_t coder, std::uint8_t revision) {
  return [=](const codec::CoderName& name) {
    return name.coder == coder && name.revision == revision;
  };
}

TEST(Efforts, StandardHasDeepTurnsForDrawingsOfFewSteps) {
  const auto small = of(codec::kCoderContours, codec::kContourSmall);
  const auto full = of(codec::kCoderContours, codec::kContourStandard);
  EXPECT_TRUE(small(coder_of(upright_strokes(400, 400, 200, 60))));
  EXPECT_TRUE(full(coder_of(tiles(600))));
  // However empty: that of a megapixel is to be read at once.
  EXPECT_TRUE(full(coder_of(*Bitmap::create(1000, 1000))));
}

TEST(Efforts, StandardTakesTheQuickWaysForScansThatDoNotRepeat) {
  const auto light = of(codec::kCoderContours, codec::kContourLight);
  const auto small = of(codec::kCoderContours, codec::kContourSmall);
  const auto pixels = of(codec::kCoderPixels, codec::kPixelsDeep);
  // Letters by the dozen on a large page, a small page, a crowded page.
  EXPECT_TRUE(light(coder_of(upright_strokes(2000, 1100, 200, 60))));
  EXPECT_TRUE(small(coder_of(upright_strokes(400, 400, 200, 60))));
  EXPECT_TRUE(pixels(coder_of(upright_strokes(2000, 1100, 5, 900))));
}

/// Pages of text, blots, thin lines, dither and single pixels.
TEST(Efforts, MaxIsNeverLargerThanStandard) {
  const std::filesystem::path folder =
      std::filesystem::path(UNSTEP_SOURCE_DIR) / "tests/golden/valid";
  int pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".ustp") continue;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::vector<std::uint8_t> file{std::istreambuf_iterator<char>(in),
                                         {}};
    const Result<UstpReader> reader = UstpReader::open(file, {});
    ASSERT_TRUE(reader);
    const Result<Page> page = reader->read_page(0);
    ASSERT_TRUE(page);
    if (page->kind != PageKind::ink) continue;
    ++pages;
    EXPECT_LE(file_size(*page, Effort::max), file_size(*page, Effort::standard))
        << entry.path();
  }
  EXPECT_GT(pages, 15);
}

}  // namespace
}  // namespace unstep
