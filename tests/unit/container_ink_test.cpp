#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "codec/container_format.h"
#include "unit/container_testing.h"
#include "unstep/codec.h"

namespace unstep {
namespace {

using testing::Bytes;
using testing::open;
using testing::random_ink;
using testing::write_pages;

void expect_round_trip(const std::vector<Bitmap>& pages,
                       const EncodeOptions& options, const PageInfo& info,
                       int jobs) {
  const Bytes file = write_pages(pages, options, info);
  const Result<UstpReader> reader = open(file, jobs);
  ASSERT_TRUE(reader) << reader.error().message;
  ASSERT_EQ(reader->info().pages.size(), pages.size());
  EXPECT_EQ(reader->info().metadata, options.metadata);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const PageEntry& entry = reader->info().pages[i];
    EXPECT_EQ(entry.checksum, pages[i].crc32());
    EXPECT_EQ(entry.info, info);
    EXPECT_EQ(entry.canvas.width, pages[i].width());
    EXPECT_EQ(entry.canvas.height, pages[i].height());
    const Result<Page> page = reader->read_page(i);
    ASSERT_TRUE(page) << page.error().message;
    EXPECT_EQ(page->kind, PageKind::ink);
    EXPECT_EQ(page->info, info);
    EXPECT_EQ(page->ink, pages[i]);
  }
}

const PageInfo kPlain;
const PageInfo kRich{"front \xc3\xa9",
                     {{600, 1}, {1200, 7}, Resolution::Unit::inch},
                     {{"tiff:Artist", "A. Drawer"}, {"empty", ""}}};

TEST(ContainerInk, RoundTripsEverySmallSize) {
  for (std::int32_t width = 1; width <= 20; ++width) {
    for (std::int32_t height = 1; height <= 10; ++height) {
      SCOPED_TRACE(::testing::Message() << width << " x " << height);
      expect_round_trip({random_ink(width, height, 7)}, {}, kPlain, 1);
    }
  }
}

TEST(ContainerInk, RoundTripsExtremeShapes) {
  for (const auto& [width, height] :
       {std::pair{1, 3000}, {3000, 1}, {65, 64}, {127, 130}, {1024, 3}}) {
    SCOPED_TRACE(::testing::Message() << width << " x " << height);
    expect_round_trip({random_ink(width, height, 11)}, {}, kPlain, 1);
    expect_round_trip({random_ink(width, height, 12)}, {}, kRich, 1);
  }
}

/// Blots on both colours, few enough that most words see nothing of them.
Bitmap sparse_ink(std::int32_t width, std::int32_t height, unsigned seed) {
  Bitmap ink = *Bitmap::create(width, height);
  std::mt19937 random(seed);
  const auto below = [&](std::int32_t n) {
    return static_cast<std::int32_t>(random() % static_cast<unsigned>(n));
  };
  for (std::int32_t y = height / 2; y < height; ++y) {
    for (std::int32_t x = 0; x < width; ++x) ink.set(x, y, true);
  }
  for (int blot = 0; blot < 24; ++blot) {
    const std::int32_t x = below(width - 8);
    const std::int32_t y = below(height - 8);
    const bool colour = !ink.get(x, y);
    const std::int32_t right = x + 1 + below(8);
    const std::int32_t bottom = y + 1 + below(8);
    for (std::int32_t v = y; v < bottom; ++v) {
      for (std::int32_t u = x; u < right; ++u) ink.set(u, v, colour);
    }
  }
  return ink;
}

/// From 16 words on rows have quiet spans; the last ones may not be whole.
TEST(ContainerInk, RoundTripsWideDrawingsThatAreMostlyEmpty) {
  for (const std::int32_t width : {959, 960, 961, 1024, 1087, 1280, 2000}) {
    for (unsigned seed = 1; seed < 6; ++seed) {
      SCOPED_TRACE(::testing::Message() << width << " wide, seed " << seed);
      for (const Effort effort :
           {Effort::fast, Effort::standard, Effort::max}) {
        EncodeOptions options;
        options.effort = effort;
        expect_round_trip({sparse_ink(width, 90, seed)}, options, kPlain, 1);
      }
    }
  }
}

TEST(ContainerInk, RoundTripsBandsWithoutDependingOnJobs) {
  const Bitmap ink = random_ink(77, 61, 3);
  for (int bands = 1; bands <= 7; ++bands) {
    SCOPED_TRACE(bands);
    EncodeOptions one;
    one.bands = bands;
    EncodeOptions four = one;
    four.jobs = 4;
    EXPECT_EQ(write_pages(std::vector{ink}, one),
              write_pages(std::vector{ink}, four));
    expect_round_trip({ink}, four, kPlain, 4);
    expect_round_trip({ink}, one, kRich, 1);
  }
}

TEST(ContainerInk, BandsHoldAboutEqualWork) {
  const auto rows_of = [](const Bitmap& ink, int bands) {
    EncodeOptions options;
    options.bands = bands;
    const Bytes file = write_pages(std::vector{ink}, options);
    const Result<UstpReader> reader = open(file);
    std::vector<std::int32_t> rows;
    for (const PageEntry::Block& block : reader->info().pages[0].blocks) {
      rows.push_back(block.rows);
    }
    return rows;
  };
  EXPECT_EQ(rows_of(*Bitmap::create(200, 90), 3),
            (std::vector<std::int32_t>{30, 30, 30}));
  Bitmap ink = *Bitmap::create(200, 400);
  const Bitmap noise = random_ink(200, 100, 8);
  for (std::int32_t y = 0; y < 100; ++y) {
    const auto row = noise.row(y);
    std::copy(row.begin(), row.end(), ink.row(300 + y).begin());
  }
  const std::vector<std::int32_t> rows = rows_of(ink, 2);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NEAR(rows[0], 350, 5);
  EXPECT_EQ(rows[0] + rows[1], 400);
}

TEST(ContainerInk, NeverMakesMoreBandsThanRows) {
  EncodeOptions options;
  options.bands = 50;
  const Bytes file = write_pages(std::vector{random_ink(9, 5, 1)}, options);
  const Result<UstpReader> reader = open(file);
  ASSERT_TRUE(reader);
  ASSERT_EQ(reader->info().pages[0].blocks.size(), 5U);
  for (const PageEntry::Block& block : reader->info().pages[0].blocks) {
    EXPECT_EQ(block.rows, 1);
  }
}

TEST(ContainerInk, RoundTripsManyPagesWithMetadata) {
  std::vector<Bitmap> pages;
  for (unsigned i = 0; i < 12; ++i) {
    pages.push_back(random_ink(static_cast<std::int32_t>(i * 13 + 1),
                               static_cast<std::int32_t>(i + 1), i));
  }
  EncodeOptions options;
  options.metadata = {{"title", "twelve pages"},
                      {"note", "a\nb\t\xe2\x82\xac"}};
  expect_round_trip(pages, options, kRich, 1);
  options.bands = 3;
  expect_round_trip(pages, options, kPlain, 3);
}

TEST(ContainerInk, KeepsUnusualResolutionsExactly) {
  const std::uint32_t max = 0xffffffffU;
  for (const Resolution& resolution :
       {Resolution{{max, max - 1}, {1, max}, Resolution::Unit::metre},
        Resolution{{204, 1}, {98, 1}, Resolution::Unit::inch},
        Resolution{{3, 1}, {2, 1}, Resolution::Unit::none},
        Resolution{{0, 1}, {0, 1}, Resolution::Unit::centimetre}}) {
    PageInfo info;
    info.resolution = resolution;
    expect_round_trip({random_ink(30, 30, 2)}, {}, info, 1);
  }
}

TEST(ContainerInk, ShortFormCostsTenToThirteenBytes) {
  for (const auto& [width, height] :
       {std::pair{8, 8}, {127, 127}, {500, 300}, {16383, 20}}) {
    const Bytes file =
        write_pages(std::vector{random_ink(width, height, 5)}, {});
    const Result<UstpReader> reader = open(file);
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->info().form, FileInfo::Form::short_form);
    const PageEntry::Block& block = reader->info().pages[0].blocks[0];
    EXPECT_EQ(block.offset + block.bytes, file.size());
    // One less for square pages and for the usual coder.
    const bool usual = block.coder == 1;
    EXPECT_EQ(block.offset + (width == height ? 1 : 0) + (usual ? 1 : 0),
              width < 128    ? 12U
              : height < 128 ? 13U
                             : 14U);
  }
}

TEST(ContainerInk, OnePageKeepsTheShortFormWhateverIsSaidOfIt) {
  const std::vector<Bitmap> pages{random_ink(20, 20, 6)};
  PageInfo info;
  info.resolution = {{300, 1}, {300, 1}, Resolution::Unit::inch};
  EXPECT_EQ(open(write_pages(pages, {}, info))->info().form,
            FileInfo::Form::short_form);
  info.name = "a";
  info.metadata = {{"tiff:Software", "a scanner"}};
  EncodeOptions options;
  options.metadata = {{"unstep:source-size", "1234"}};
  const Bytes file = write_pages(pages, options, info);
  const Result<UstpReader> reader = open(file);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->info().form, FileInfo::Form::short_form);
  EXPECT_EQ(reader->info().metadata, options.metadata);
  EXPECT_EQ(reader->info().pages[0].info.name, info.name);
  EXPECT_EQ(reader->info().pages[0].info.metadata, info.metadata);
  EXPECT_EQ(reader->info().pages[0].info.resolution, info.resolution);
}

TEST(ContainerInk, WordsThatAreOftenSaidCostLittle) {
  const std::vector<Bitmap> pages{random_ink(20, 20, 6)};
  PageInfo info;
  info.metadata = {{"tiff:DocumentName", "Standard Input"},
                   {"tiff:ImageDescription", "converted PNM file"}};
  EXPECT_LE(write_pages(pages, {}, info).size(),
            write_pages(pages, {}).size() + 10);
}

TEST(ContainerInk, CutsBandsByItselfOnlyAboveTheDocumentedSize) {
  // 8192 x 8192 is the limit itself; one row more is two bands.
  const Bitmap limit = *Bitmap::create(8192, 8192);
  const Bitmap above = *Bitmap::create(8192, 8193);
  ASSERT_EQ(limit.pixels(), codec::kAutoBandPixels);
  EncodeOptions options;
  options.verify = false;
  const Bytes file = write_pages(std::vector{limit, above}, options);
  const Result<UstpReader> reader = open(file);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->info().pages[0].blocks.size(), 1U);
  EXPECT_EQ(reader->info().pages[1].blocks.size(), 2U);
}

}  // namespace
}  // namespace unstep
