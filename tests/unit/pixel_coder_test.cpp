#include "codec/pixel_coder.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <cstdint>
#include <random>
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
constexpr std::array<std::uint8_t, 3> kRevisions{kPixelsBlended, kPixelsMixed,
                                                 kPixelsDeep};

/// Whether coder 4 brings back those rows, and no others.
Bytes expect_round_trip(const Bitmap& ink, std::int32_t first,
                        std::int32_t rows, std::uint8_t revision) {
  const Result<Bytes> payload = encode_pixels(ink, first, rows, revision, {});
  EXPECT_TRUE(payload);
  Bitmap decoded = *Bitmap::create(ink.width(), ink.height());
  const Status done =
      decode_pixels(*payload, decoded, first, rows, revision, kLimits, {});
  EXPECT_TRUE(done) << done.error().message;
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

/// Rings of curved strokes, some of them rough.
Bitmap drawing(std::int32_t width, std::int32_t height,
               std::int32_t scale = 97) {
  std::mt19937 random(5);
  Bitmap ink = *Bitmap::create(width, height);
  for (std::int32_t y = 0; y < height; ++y) {
    for (std::int32_t x = 0; x < width; ++x) {
      const std::int32_t d = (x * x + 2 * y * y) / scale % 64;
      const bool rough = x % 128 < 40 && random() % 4 == 0 && d % 20 == 0;
      ink.set(x, y, (d < 20) != rough);
    }
  }
  return ink;
}

/// Floyd and Steinberg's error diffusion of a smooth picture.
Bitmap dithered(std::int32_t width, std::int32_t height) {
  const auto size = static_cast<std::size_t>(width) + 2;
  std::vector<std::int32_t> here(size);
  std::vector<std::int32_t> below(size);
  Bitmap ink = *Bitmap::create(width, height);
  for (std::int32_t y = 0; y < height; ++y) {
    for (std::int32_t x = 0; x < width; ++x) {
      const auto i = static_cast<std::size_t>(x) + 1;
      const std::int32_t grey = 20 + (x * 3 + y * y / 50) % 200 + here[i] / 16;
      const bool black = grey >= 128;
      ink.set(x, y, black);
      const std::int32_t error = grey - (black ? 255 : 0);
      if (i + 1 < size) here[i + 1] += error * 7;
      below[i - 1] += error * 3;
      below[i] += error * 5;
      if (i + 1 < size) below[i + 1] += error;
    }
    here.swap(below);
    below.assign(size, 0);
  }
  return ink;
}

TEST(Pixels, ComeBackFromInkOfAnyShape) {
  for (const std::uint8_t revision : kRevisions) {
    for (const auto& [width, height] :
         std::vector<std::array<std::int32_t, 2>>{{1, 1},
                                                  {1, 300},
                                                  {300, 1},
                                                  {63, 9},
                                                  {64, 9},
                                                  {65, 9},
                                                  {128, 5},
                                                  {130, 37}}) {
      for (unsigned seed = 1; seed < 4; ++seed) {
        expect_round_trip(random_ink(width, height, seed), 0, height, revision);
      }
      expect_round_trip(*Bitmap::create(width, height), 0, height, revision);
    }
    expect_round_trip(ink_of({"#########", "#########", "#########"}), 0, 3,
                      revision);
    expect_round_trip(drawing(501, 203), 0, 203, revision);
    expect_round_trip(dithered(301, 103), 0, 103, revision);
  }
}

TEST(Pixels, TakeSomeRowsOnly) {
  const Bitmap ink = drawing(150, 120);
  for (const std::uint8_t revision : kRevisions) {
    expect_round_trip(ink, 0, 50, revision);
    expect_round_trip(ink, 50, 70, revision);
  }
}

/// Every compiler makes the same bytes; the golden files have no revision 0.
TEST(Pixels, HaveTheseBytes) {
  const Bitmap ink = drawing(501, 203);
  const auto sum = [&](std::uint8_t revision) {
    const Bytes payload = *encode_pixels(ink, 0, 203, revision, {});
    return crc32(0, payload.data(), static_cast<uInt>(payload.size()));
  };
  EXPECT_EQ(sum(kPixelsBlended), 2835737425U);
  EXPECT_EQ(sum(kPixelsMixed), 2297854131U);
  EXPECT_EQ(sum(kPixelsDeep), 2664351131U);
}

TEST(Pixels, ArePickedForDitherAndSmallerThere) {
  const Bitmap ink = dithered(300, 300);
  ASSERT_TRUE(pixel_texture(ink, 0, 300).is_dithered());
  const Result<EncodedBlock> block =
      encode_ink(ink, 0, 300, Effort::standard, {});
  ASSERT_TRUE(block);
  EXPECT_EQ(block->name, (CoderName{kCoderPixels, kPixelsDeep, kPixelTable}));
  const Result<EncodedBlock> fast = encode_ink(ink, 0, 300, Effort::fast, {});
  ASSERT_TRUE(fast);
  EXPECT_EQ(fast->name, (CoderName{kCoderPixels, kPixelsMixed, kPixelTable}));
  const Result<Bytes> contours =
      encode_contours(ink, 0, 300, kContourStandard, {});
  ASSERT_TRUE(contours);
  EXPECT_LT(block->payload.size(), contours->size());
}

TEST(Pixels, AreWhatIsFastOnLargePages) {
  const Bitmap ink = drawing(1200, 1000, 2000);
  const Result<EncodedBlock> block = encode_ink(ink, 0, 1000, Effort::fast, {});
  ASSERT_TRUE(block);
  EXPECT_EQ(block->name,
            (CoderName{kCoderPixels, kPixelsBlended, kPixelTable}));
  const Result<EncodedBlock> part = encode_ink(ink, 0, 100, Effort::fast, {});
  ASSERT_TRUE(part);
  EXPECT_EQ(part->name.coder, kCoderContours);

  Bitmap straight = *Bitmap::create(1200, 1000);
  for (std::int32_t y = 0; y < 1000; ++y) {
    for (std::int32_t x = 0; x < 1200; x += 40) {
      straight.set(x + y / 100, y, true);
    }
  }
  const Result<EncodedBlock> drawn =
      encode_ink(straight, 0, 1000, Effort::fast, {});
  ASSERT_TRUE(drawn);
  EXPECT_EQ(drawn->name.revision, kPixelsMixed);
}

TEST(Pixels, OfNoiseAreStoredAsTheyAre) {
  const Result<EncodedBlock> block =
      encode_ink(random_ink(300, 300, 7), 0, 300, Effort::standard, {});
  ASSERT_TRUE(block);
  EXPECT_LE(block->payload.size(), 300U * 38U + 20U);
}

TEST(Pixels, DamagedPayloadsAreRefusedOrSomethingElse) {
  const Bitmap ink = drawing(150, 120);
  for (const std::uint8_t revision : kRevisions) {
    const Bytes payload = expect_round_trip(ink, 0, 120, revision);
    std::size_t refused = 0;
    for (std::size_t i = 0; i < payload.size(); i += 7) {
      Bytes damaged = payload;
      damaged[i] ^= static_cast<std::uint8_t>(1U << i % 8);
      Bitmap decoded = *Bitmap::create(150, 120);
      const Status done =
          decode_pixels(damaged, decoded, 0, 120, revision, kLimits, {});
      if (!done) ++refused;
      EXPECT_FALSE(done && decoded == ink);
    }
    EXPECT_GT(refused, payload.size() / 7 / 2);
    for (std::size_t size = 0; size < payload.size(); size += 11) {
      Bitmap decoded = *Bitmap::create(150, 120);
      const Status done = decode_pixels({payload.data(), size}, decoded, 0, 120,
                                        revision, kLimits, {});
      EXPECT_FALSE(done && decoded == ink);
    }
  }
}

TEST(Pixels, KeepToTheMemoryLimit) {
  for (const std::uint8_t revision : kRevisions) {
    DecodeLimits limits;
    limits.max_memory = pixel_memory(100, revision) - 1;
    Bitmap decoded = *Bitmap::create(100, 100);
    const Status done =
        decode_pixels({}, decoded, 0, 100, revision, limits, {});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::limit_exceeded);
  }
}

TEST(Pixels, CanBeCancelled) {
  const Result<Bytes> payload =
      encode_pixels(drawing(100, 200), 0, 200, kPixelsBlended,
                    [](std::uint64_t row) { return row < 64; });
  ASSERT_FALSE(payload);
  EXPECT_EQ(payload.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace unstep::codec
