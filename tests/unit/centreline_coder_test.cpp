#include "codec/centreline_coder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include "codec/block_coder.h"
#include "codec/contour_coder.h"
#include "unit/container_testing.h"

namespace unstep::codec {
namespace {

using testing::ink_of;
using testing::random_ink;
using Bytes = std::vector<std::uint8_t>;

constexpr DecodeLimits kLimits{};

/// Whether a revision of coder 3 brings back those rows, and no others.
Bytes expect_round_trip_by(std::uint8_t revision, const Bitmap& ink,
                           std::int32_t first, std::int32_t rows) {
  const Result<Bytes> payload =
      encode_centrelines(ink, first, rows, revision, {});
  EXPECT_TRUE(payload);
  Bitmap decoded = *Bitmap::create(ink.width(), ink.height());
  const Status done =
      decode_centrelines(*payload, decoded, first, rows, revision, kLimits, {});
  EXPECT_TRUE(done) << done.error().message;
  EXPECT_TRUE(
      verify_centrelines(*payload, ink, first, rows, revision, kLimits, {}));
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    for (std::int32_t x = 0; x < ink.width(); ++x) {
      const bool inside = y >= first && y < first + rows;
      if (decoded.get(x, y) != (inside && ink.get(x, y))) {
        ADD_FAILURE() << "differs at " << x << ", " << y;
        return *payload;
      }
    }
  }
  return *payload;
}

/// Both do; returns what the first one made.
Bytes expect_round_trip(const Bitmap& ink, std::int32_t first,
                        std::int32_t rows) {
  expect_round_trip_by(kCentrelinesDeep, ink, first, rows);
  return expect_round_trip_by(kCentrelinesMixed, ink, first, rows);
}

void draw(Bitmap& ink, Point a, Point b) {
  const std::int32_t steps =
      std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), 1});
  for (std::int32_t i = 0; i <= steps; ++i) {
    ink.set(a.x + (b.x - a.x) * i / steps, a.y + (b.y - a.y) * i / steps, true);
  }
}

/// Thin polygons on a grid, as of a map, that cross and touch each other and
/// the edges.
Bitmap thin_drawing(std::int32_t width, std::int32_t height, int polygons,
                    std::int32_t grid = 15) {
  std::mt19937 random(11);
  const auto below = [&](std::int32_t n) {
    return static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(n));
  };
  const auto move = [&] { return grid * (below(5) - 2); };
  Bitmap ink = *Bitmap::create(width, height);
  for (int i = 0; i < polygons; ++i) {
    const Point first{grid * below(width / grid), grid * below(height / grid)};
    Point at = first;
    for (int corner = 0; corner < 3; ++corner) {
      const Point next{std::clamp(at.x + move(), 0, width - 1),
                       std::clamp(at.y + move(), 0, height - 1)};
      draw(ink, at, next);
      at = next;
    }
    draw(ink, at, first);
  }
  return ink;
}

TEST(Centrelines, ComeBackFromInkOfAnyShape) {
  for (const auto& [width, height] : std::vector<std::array<std::int32_t, 2>>{
           {1, 1}, {1, 300}, {300, 1}, {63, 9}, {64, 9}, {65, 9}, {130, 37}}) {
    for (unsigned seed = 1; seed < 4; ++seed) {
      expect_round_trip(random_ink(width, height, seed), 0, height);
    }
  }
  expect_round_trip(ink_of({"..", ".."}), 0, 2);
  expect_round_trip(ink_of({"#########", "#########", "#########"}), 0, 3);
  expect_round_trip(thin_drawing(301, 203, 40), 0, 203);
}

TEST(Centrelines, TakeSomeRowsOnly) {
  const Bitmap ink = thin_drawing(150, 120, 20);
  expect_round_trip(ink, 0, 50);
  expect_round_trip(ink, 50, 70);
}

TEST(Centrelines, ArePickedForThinLinesAndSmallerThere) {
  // Short lines, as of coasts: of long ones contours know as much.
  const Bitmap ink = thin_drawing(400, 400, 100, 4);
  ASSERT_TRUE(is_thin(ink, 0, ink.height()));
  const Bytes payload = expect_round_trip(ink, 0, ink.height());
  const Result<Bytes> contours =
      encode_contours(ink, 0, ink.height(), kContourStandard, {});
  ASSERT_TRUE(contours);
  EXPECT_LT(payload.size(), contours->size());
  const Result<EncodedBlock> block =
      encode_ink(ink, 0, ink.height(), Effort::standard, {});
  ASSERT_TRUE(block);
  EXPECT_EQ(block->name.coder, kCoderCentrelines);
  EXPECT_EQ(block->payload, payload);
}

/// Tiles that cross and branch, each the same: lines learn them sooner.
Bitmap tiled(std::int32_t side) {
  const Bitmap tile = thin_drawing(400, 400, 30);
  Bitmap ink = *Bitmap::create(side, side);
  for (std::int32_t y = 0; y < side; ++y) {
    for (std::int32_t x = 0; x < side; ++x) {
      if (tile.get(x % 400, y % 400)) ink.set(x, y, true);
    }
  }
  return ink;
}

TEST(Centrelines, OfMuchInkArePickedByAPartOfIt) {
  const Bitmap ink = tiled(1600);
  ASSERT_GT(ink.ink(), 32768U);
  const Result<EncodedBlock> block =
      encode_ink(ink, 0, ink.height(), Effort::standard, {});
  ASSERT_TRUE(block);
  const Result<Bytes> contours =
      encode_contours(ink, 0, ink.height(), kContourStandard, {});
  const Result<Bytes> lines =
      encode_centrelines(ink, 0, ink.height(), kCentrelinesMixed, {});
  ASSERT_TRUE(contours && lines);
  const std::size_t best = std::min(contours->size(), lines->size());
  EXPECT_LT(block->payload.size(), best * 11 / 10);
}

TEST(Centrelines, AreNotPickedWhereContoursAreSmaller) {
  Bitmap small = *Bitmap::create(60, 60);  // contours know such from the start
  for (std::int32_t i = 5; i < 55; ++i) small.set(i, 30, true);
  EXPECT_FALSE(is_thin(small, 0, 60));
  const Result<EncodedBlock> block =
      encode_ink(small, 0, 60, Effort::standard, {});
  ASSERT_TRUE(block);
  EXPECT_EQ(block->name.coder, kCoderContours);

  Bitmap area = *Bitmap::create(300, 300);
  EXPECT_FALSE(is_thin(area, 0, 300));
  for (std::int32_t y = 10; y < 50; ++y) {
    for (std::int32_t x = 10; x < 50; ++x) area.set(x, y, true);
  }
  EXPECT_FALSE(is_thin(area, 0, 300));
}

TEST(Centrelines, DamagedPayloadsAreRefusedOrSomethingElse) {
  const Bitmap ink = thin_drawing(150, 120, 12);
  for (const std::uint8_t revision : {kCentrelinesMixed, kCentrelinesDeep}) {
    const Bytes payload = expect_round_trip_by(revision, ink, 0, 120);
    std::size_t refused = 0;
    for (std::size_t i = 0; i < payload.size(); i += 3) {
      Bytes damaged = payload;
      damaged[i] ^= static_cast<std::uint8_t>(1U << i % 8);
      Bitmap decoded = *Bitmap::create(150, 120);
      if (!decode_centrelines(damaged, decoded, 0, 120, revision, kLimits,
                              {})) {
        ++refused;
      }
      EXPECT_FALSE(
          verify_centrelines(damaged, ink, 0, 120, revision, kLimits, {}));
    }
    EXPECT_GT(refused, payload.size() / 4);
    for (std::size_t size = 0; size < payload.size(); size += 5) {
      EXPECT_FALSE(verify_centrelines({payload.data(), size}, ink, 0, 120,
                                      revision, kLimits, {}));
    }
  }
}

TEST(Centrelines, KeepToTheMemoryLimit) {
  for (const std::uint8_t revision : {kCentrelinesMixed, kCentrelinesDeep}) {
    DecodeLimits limits;
    limits.max_memory = centreline_memory(revision, 100, 100) - 1;
    Bitmap decoded = *Bitmap::create(100, 100);
    const Status done =
        decode_centrelines({}, decoded, 0, 100, revision, limits, {});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::limit_exceeded);
  }
}

TEST(Centrelines, GiveUpWhereTooManyBranchesWait) {
  // A field of crossings, two pixels apart: each step leaves branches behind.
  const auto field = [](std::int32_t side) {
    Bitmap ink = *Bitmap::create(side, side);
    for (std::int32_t y = 0; y < side; ++y) {
      for (std::int32_t x = 0; x < side; ++x) {
        ink.set(x, y, x % 2 == 0 || y % 2 == 0);
      }
    }
    return ink;
  };
  EXPECT_FALSE(expect_round_trip(field(200), 0, 200).empty());
  const Result<Bytes> none =
      encode_centrelines(field(700), 0, 700, kCentrelinesMixed, {});
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->empty());
}

TEST(Centrelines, TellProgressAndCanBeCancelled) {
  const Bitmap ink = thin_drawing(200, 200, 12);
  std::uint64_t last = 0;
  const BlockProgress count = [&](std::uint64_t done) {
    EXPECT_GT(done, last);
    last = done;
    return done < 100;
  };
  const Result<Bytes> payload =
      encode_centrelines(ink, 0, 200, kCentrelinesMixed, count);
  ASSERT_FALSE(payload);
  EXPECT_EQ(payload.error().code, ErrorCode::cancelled);
  EXPECT_EQ(last, 128U);
}

}  // namespace
}  // namespace unstep::codec
