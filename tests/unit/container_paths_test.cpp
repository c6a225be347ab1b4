#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "codec/path_checksum.h"
#include "unit/container_testing.h"
#include "unit/path_testing.h"
#include "unstep/codec.h"

namespace unstep {
namespace {

using testing::arc;
using testing::Bytes;
using testing::line;
using testing::random_paths;

Bytes write_drawing(const Drawing& drawing, const Fidelity& fidelity = {},
                    EncodeOptions options = {}, const PageInfo& info = {}) {
  UstpWriter writer(std::move(options));
  const Status added = writer.add_page(drawing, info, fidelity);
  EXPECT_TRUE(added) << added.error().message;
  Result<Bytes> file = writer.finish();
  EXPECT_TRUE(file) << file.error().message;
  return file ? *std::move(file) : Bytes{};
}

Drawing drawing_of(std::vector<Path> paths) {
  Drawing drawing;
  drawing.canvas = {300, 200, YAxis::down};
  drawing.paths = std::move(paths);
  return drawing;
}

TEST(PathPages, ComeBackFromBothForms) {
  PageInfo named;
  named.name = "sheet";
  for (const YAxis axis : {YAxis::up, YAxis::down}) {
    for (const Paint paint : {Paint::fill, Paint::stroke}) {
      for (const std::int32_t scale : {1, 2, Drawing::kMaxScale}) {
        Drawing drawing = drawing_of(random_paths(7, 6, 20));
        drawing.canvas.y_axis = axis;
        drawing.paint = paint;
        drawing.scale = scale;
        for (const PageInfo& info : {PageInfo{}, named}) {
          const Bytes file = write_drawing(drawing, {}, {}, info);
          const auto reader = testing::open(file);
          ASSERT_TRUE(reader) << reader.error().message;
          const PageEntry& entry = reader->info().pages[0];
          EXPECT_EQ(entry.kind, PageKind::paths);
          EXPECT_EQ(entry.canvas, drawing.canvas);
          EXPECT_EQ(entry.scale, scale);
          EXPECT_EQ(entry.paint, paint);
          EXPECT_EQ(entry.checksum, codec::crc_paths(drawing.paths));
          const auto page = reader->read_page(0);
          ASSERT_TRUE(page) << page.error().message;
          EXPECT_EQ(page->drawing, drawing);
          EXPECT_EQ(page->info, info);
        }
      }
    }
  }
}

TEST(PathPages, KeepTheirFidelity) {
  using Kind = Fidelity::Kind;
  const Drawing drawing = drawing_of(random_paths(8, 3, 9));
  for (const Fidelity& fidelity :
       {Fidelity{}, Fidelity{Kind::device, {}},
        Fidelity{Kind::tolerance, {1, 1}}, Fidelity{Kind::tolerance, {3, 4}},
        Fidelity{Kind::tolerance, {0xffffffff, 0xfffffffe}}}) {
    const Bytes file = write_drawing(drawing, fidelity);
    const auto reader = testing::open(file);
    ASSERT_TRUE(reader) << reader.error().message;
    EXPECT_EQ(reader->info().pages[0].fidelity, fidelity);
    EXPECT_EQ(reader->read_page(0)->fidelity, fidelity);
  }
}

TEST(PathPages, MayBeEmptyWithinATolerance) {
  const Fidelity one{Fidelity::Kind::tolerance, {1, 1}};
  const Bytes file = write_drawing(drawing_of({}), one);
  const auto reader = testing::open(file);
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ(reader->info().pages[0].kind, PageKind::paths);
  const auto page = reader->read_page(0);
  ASSERT_TRUE(page) << page.error().message;
  EXPECT_EQ(page->fidelity, one);
  EXPECT_TRUE(page->drawing.paths.empty());
}

TEST(PathPages, CostFewBytesBesideTheirPayload) {
  const Bytes file = write_drawing(drawing_of({{{5, 5}, false, 0, {}}}),
                                   {Fidelity::Kind::tolerance, {1, 1}});
  const auto reader = testing::open(file);
  ASSERT_TRUE(reader);
  EXPECT_LE(reader->info().pages[0].blocks[0].offset, 18U);
}

TEST(PathPages, RefuseWhatCannotBeStored) {
  const auto refused = [](const Drawing& drawing, const Fidelity& fidelity) {
    UstpWriter writer{EncodeOptions{}};
    const Status added = writer.add_page(drawing, {}, fidelity);
    EXPECT_FALSE(added);
    return added ? ErrorCode::internal : added.error().code;
  };
  const ErrorCode invalid = ErrorCode::invalid_argument;
  Drawing drawing = drawing_of(random_paths(9, 2, 5));
  EXPECT_EQ(refused(drawing, {Fidelity::Kind::tolerance, {1, 0}}), invalid);
  EXPECT_EQ(refused(drawing, {static_cast<Fidelity::Kind>(3), {}}), invalid);
  drawing.scale = 0;
  EXPECT_EQ(refused(drawing, {}), ErrorCode::out_of_range);
  drawing.scale = Drawing::kMaxScale + 1;
  EXPECT_EQ(refused(drawing, {}), ErrorCode::out_of_range);
  drawing.scale = 1;
  drawing.paint = static_cast<Paint>(2);
  EXPECT_EQ(refused(drawing, {}), invalid);
  Drawing chains;
  chains.chains = {Chain{}};
  EXPECT_EQ(refused(chains, {Fidelity::Kind::device, {}}), invalid);
  chains.paths = {Path{}};
  EXPECT_EQ(refused(chains, {}), invalid);
}

TEST(PathPages, LimitsAreCheckedBeforeDecoding) {
  const Bytes file = write_drawing(drawing_of(random_paths(10, 30, 30)));
  for (const bool memory : {false, true}) {
    DecodeOptions options;
    (memory ? options.limits.max_memory : options.limits.max_steps) = 100;
    const auto reader = UstpReader::open(file, options);
    ASSERT_TRUE(reader);
    const auto page = reader->read_page(0);
    ASSERT_FALSE(page);
    EXPECT_EQ(page.error().code, ErrorCode::limit_exceeded);
  }
}

Box box_of(const Path& path, const codec::PathSpace& space = {}) {
  return codec::survey_paths({&path, 1}, space)->box;
}

TEST(PathBoxes, HoldWhatIsDrawn) {
  EXPECT_EQ(box_of({{2, 3}, false, 0, {}}), (Box{2, 3, 0, 0}));
  EXPECT_EQ(box_of({{2, 3}, false, 7, {line(-5, 1)}}), (Box{-3, 3, 5, 1}));
  // A pen of 7 reaches 4, rounded up, to all sides.
  EXPECT_EQ(box_of({{2, 3}, false, 7, {line(-5, 1)}},
                   {YAxis::down, 1, Paint::stroke}),
            (Box{-7, -1, 13, 9}));
  EXPECT_EQ(box_of({{-1, 3}, false, 0, {line(5, 6)}}, {YAxis::down, 4, {}}),
            (Box{-1, 0, 2, 3}));
  // From (0, 0) to (10, 10) round (10, 0): the near quarter or the far three,
  // by the numbers, whatever the axis.
  EXPECT_EQ(box_of({{}, false, 0, {arc({10, 0}, {10, 10}, true)}}),
            (Box{0, 0, 10, 10}));
  EXPECT_EQ(box_of({{}, false, 0, {arc({10, 0}, {10, 10}, false)}}),
            (Box{0, -10, 20, 20}));
  EXPECT_EQ(box_of({{}, false, 0, {arc({10, 0}, {10, 10}, true)}},
                   {YAxis::up, 1, {}}),
            (Box{0, 0, 10, 10}));
  EXPECT_EQ(box_of({{}, true, 0, {arc({3, 4}, {})}}), (Box{-2, -1, 10, 10}));
}

/// Dots, one below the other, enough of them for some groups.
Drawing tall_drawing() {
  Drawing drawing;
  for (std::int32_t i = 0; i < 40'000; ++i) {
    drawing.paths.push_back({{i % 7, i * 1000}, false, 0, {}});
  }
  return drawing;
}

TEST(PathPages, LargeOnesAreCutIntoGroupsThatDecodeAlone) {
  const Drawing drawing = tall_drawing();
  EncodeOptions options;
  const Bytes file = write_drawing(drawing, {}, options);
  options.jobs = 3;
  EXPECT_EQ(write_drawing(drawing, {}, options), file) << "whatever the jobs";
  const auto reader = testing::open(file, 2);
  ASSERT_TRUE(reader) << reader.error().message;
  const std::vector<PageEntry::Block>& blocks = reader->info().pages[0].blocks;
  ASSERT_GE(blocks.size(), 2U);
  const auto whole = reader->read_page(0);
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(whole->drawing, drawing);
  std::size_t first = 0;
  for (const PageEntry::Block& block : blocks) {
    const Box middle{block.box.x, block.box.y + 1500, 1, 1};
    const auto part = reader->read_page(0, middle);
    ASSERT_TRUE(part) << part.error().message;
    ASSERT_EQ(part->drawing.paths.size(), block.paths);
    EXPECT_TRUE(
        std::equal(part->drawing.paths.begin(), part->drawing.paths.end(),
                   drawing.paths.begin() + static_cast<std::ptrdiff_t>(first)));
    first += static_cast<std::size_t>(block.paths);
  }
  const auto none = reader->read_page(0, {0, -500'000'000, 10, 10});
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_TRUE(none->drawing.paths.empty());
}

TEST(PathPages, ADamagedGroupHurtsOnlyThoseWhoNeedIt) {
  const Drawing drawing = tall_drawing();
  const Bytes file = write_drawing(drawing);
  const auto intact = testing::open(file);
  ASSERT_TRUE(intact);
  const std::vector<PageEntry::Block> blocks = intact->info().pages[0].blocks;
  ASSERT_GE(blocks.size(), 2U);
  // In memory only: a block's CRC would be wrong when opened.
  Bytes damaged = file;
  const auto reader = testing::open(damaged);
  ASSERT_TRUE(reader);
  damaged[static_cast<std::size_t>(blocks[1].offset + blocks[1].bytes / 2)] ^=
      0x40;
  EXPECT_TRUE(reader->read_page(0, {0, 1000, 1, 1}));
  const auto page = reader->read_page(0);
  ASSERT_FALSE(page);
  EXPECT_NE(page.error().message.find("block 2"), std::string::npos)
      << page.error().message;
}

TEST(ChainPages, LargeOnesAreCutIntoGroups) {
  Drawing drawing;
  for (std::int32_t i = 0; i < 12; ++i) {
    Chain chain{{0, i * 1000}, Connectivity::eight, false, {}};
    chain.steps.assign(100'000, 0);
    drawing.chains.push_back(chain);
  }
  const Bytes file = write_drawing(drawing);
  const auto reader = testing::open(file, 2);
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_GE(reader->info().pages[0].blocks.size(), 2U);
  EXPECT_EQ(reader->read_page(0)->drawing, drawing);
  const auto part = reader->read_page(0, {0, 0, 5, 5});
  ASSERT_TRUE(part) << part.error().message;
  EXPECT_EQ(part->drawing.chains.size(),
            reader->info().pages[0].blocks[0].chains);
}

TEST(InkPages, ABoxIsCutOut) {
  const Bitmap ink = testing::random_ink(150, 61, 12);
  for (const int bands : {1, 4}) {
    EncodeOptions options;
    options.bands = bands;
    const Bytes file = testing::write_pages({&ink, 1}, options);
    const auto reader = testing::open(file);
    ASSERT_TRUE(reader);
    for (const Box& box :
         {Box{0, 0, 150, 61}, Box{5, 20, 70, 1}, Box{64, 16, 64, 14},
          Box{63, 0, 2, 2}, Box{-3, -4, 10, 10}, Box{140, 50, 900, 900},
          Box{149, 60, 1, 1}}) {
      const auto page = reader->read_page(0, box);
      ASSERT_TRUE(page) << page.error().message;
      const std::int32_t left = std::max(box.x, 0);
      const std::int32_t top = std::max(box.y, 0);
      const auto right =
          std::min<std::int64_t>(150, std::int64_t{box.x} + box.width);
      const auto bottom =
          std::min<std::int64_t>(61, std::int64_t{box.y} + box.height);
      Bitmap expected = *Bitmap::create(right - left, bottom - top);
      for (std::int32_t y = 0; y < expected.height(); ++y) {
        for (std::int32_t x = 0; x < expected.width(); ++x) {
          expected.set(x, y, ink.get(left + x, top + y));
        }
      }
      EXPECT_EQ(page->ink, expected) << box.x << " " << box.y;
    }
    for (const Box& box : {Box{150, 0, 5, 5}, Box{0, -5, 5, 5}, Box{3, 3, 0, 9},
                           Box{3, 3, 9, 0}, Box{0, 61, 5, 5}}) {
      const auto page = reader->read_page(0, box);
      ASSERT_FALSE(page);
      EXPECT_EQ(page.error().code, ErrorCode::out_of_range);
    }
  }
}

TEST(InkPages, ABoxNeedsMemoryForItsBandsOnly) {
  const Bitmap ink = testing::random_ink(640, 400, 13);
  EncodeOptions options;
  options.bands = 8;
  const Bytes file = testing::write_pages({&ink, 1}, options);
  DecodeOptions limited;
  limited.limits.max_pixels = 640 * 56;  // a band has about 50 rows
  const auto reader = UstpReader::open(file, limited);
  ASSERT_TRUE(reader);
  EXPECT_FALSE(reader->read_page(0));
  EXPECT_TRUE(reader->read_page(0, {10, 60, 30, 30}));
  EXPECT_FALSE(reader->read_page(0, {10, 30, 30, 30}));
}

}  // namespace
}  // namespace unstep
