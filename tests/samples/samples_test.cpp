#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "unstep/codec.h"
#include "unstep/formats.h"

namespace unstep {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxBytes = 1 << 24;

std::vector<std::string> samples(bool chains) {
  std::vector<std::string> names;
  const fs::path folder = fs::path(UNSTEP_SOURCE_DIR) / "samples";
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string kind = entry.path().extension().string();
    const bool raster = kind == ".tif" || kind == ".png" || kind == ".pbm";
    if (chains ? kind == ".fc" : raster) {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::uint8_t> bytes_of(const std::string& name) {
  const fs::path path = fs::path(UNSTEP_SOURCE_DIR) / "samples" / name;
  auto bytes = read_file(path.string(), kMaxBytes);
  EXPECT_TRUE(bytes) << bytes.error().message;
  return bytes ? std::move(*bytes) : std::vector<std::uint8_t>{};
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == '-'; },
      '_');
  return name;
}

class RasterSample : public testing::TestWithParam<std::string> {};

TEST_P(RasterSample, ComesBackWithPixelsAndDescription) {
  std::vector<std::uint8_t> source = bytes_of(GetParam());
  auto file = RasterReader::open(std::move(source), {});
  ASSERT_TRUE(file) << file.error().message;

  std::vector<RasterPage> pages;
  UstpWriter writer({});
  for (std::size_t i = 0; i < file->page_count(); ++i) {
    auto page = file->read(i);
    ASSERT_TRUE(page) << page.error().message;
    EXPECT_TRUE(page->lossless);
    const Status added = writer.add_page(page->ink, page->info);
    ASSERT_TRUE(added) << added.error().message;
    pages.push_back(std::move(*page));
  }
  const auto packed = writer.finish();
  ASSERT_TRUE(packed) << packed.error().message;

  const auto reader = UstpReader::open(*packed, {});
  ASSERT_TRUE(reader) << reader.error().message;
  ASSERT_EQ(reader->info().pages.size(), pages.size());
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const auto page = reader->read_page(i);
    ASSERT_TRUE(page) << page.error().message;
    EXPECT_EQ(page->kind, PageKind::ink);
    EXPECT_EQ(page->ink, pages[i].ink);
    EXPECT_EQ(page->info, pages[i].info);
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, RasterSample,
                         testing::ValuesIn(samples(false)), test_name);

class ChainSample : public testing::TestWithParam<std::string> {};

TEST_P(ChainSample, ComesBackStepForStep) {
  const std::vector<std::uint8_t> source = bytes_of(GetParam());
  const auto drawing =
      parse_freeman(std::string(source.begin(), source.end()), {});
  ASSERT_TRUE(drawing) << drawing.error().message;
  ASSERT_FALSE(drawing->chains.empty());

  UstpWriter writer({});
  const Status added = writer.add_page(*drawing, {});
  ASSERT_TRUE(added) << added.error().message;
  const auto packed = writer.finish();
  ASSERT_TRUE(packed) << packed.error().message;
  EXPECT_LT(packed->size(), source.size());

  const auto reader = UstpReader::open(*packed, {});
  ASSERT_TRUE(reader) << reader.error().message;
  const auto page = reader->read_page(0);
  ASSERT_TRUE(page) << page.error().message;
  EXPECT_EQ(page->kind, PageKind::chains);
  EXPECT_EQ(page->drawing, *drawing);
}

INSTANTIATE_TEST_SUITE_P(Samples, ChainSample, testing::ValuesIn(samples(true)),
                         test_name);

TEST(Samples, AreOfManyKinds) {
  EXPECT_THAT(samples(false),
              testing::IsSupersetOf({"text-page.tif", "score-2pages.tif",
                                     "schematic.tif", "coast.png", "crown.png",
                                     "molecule-8bit.png", "glyph.pbm"}));
  EXPECT_THAT(samples(true), testing::Contains("strokes.fc"));
}

TEST(Samples, KeepTheResolutionOfTheScan) {
  auto file = RasterReader::open(bytes_of("text-page.tif"), {});
  ASSERT_TRUE(file) << file.error().message;
  const auto page = file->read(0);
  ASSERT_TRUE(page) << page.error().message;
  const Resolution& resolution = page->info.resolution;
  EXPECT_EQ(resolution.unit, Resolution::Unit::inch);
  ASSERT_NE(resolution.x.denominator, 0U);
  EXPECT_EQ(resolution.x.numerator / resolution.x.denominator, 300U);
  EXPECT_EQ(resolution.x, resolution.y);
}

}  // namespace
}  // namespace unstep
