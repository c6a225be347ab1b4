#include "unstep/bitmap.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace unstep {
namespace {

TEST(Bitmap, RefusesSidesOutOfRange) {
  for (const auto& [w, h] : {std::pair<std::int64_t, std::int64_t>{0, 1},
                             {1, 0},
                             {-1, 5},
                             {std::int64_t{1} << 30, 1}}) {
    const Result<Bitmap> bitmap = Bitmap::create(w, h);
    ASSERT_FALSE(bitmap);
    EXPECT_EQ(bitmap.error().code, ErrorCode::out_of_range);
  }
}

TEST(Bitmap, RowBytesRoundTripAndKeepUnusedBitsZero) {
  std::mt19937 random(1);
  for (const std::int32_t width : {1, 7, 8, 9, 63, 64, 65, 130}) {
    Bitmap bitmap = *Bitmap::create(width, 2);
    std::vector<std::uint8_t> in((static_cast<std::size_t>(width) + 7) / 8);
    for (auto& byte : in) byte = static_cast<std::uint8_t>(random());
    for (const bool invert : {false, true}) {
      bitmap.set_row_bytes(1, in, invert);
      EXPECT_EQ(bitmap.row(1).back() & ~bitmap.last_word_mask(), 0U);
      for (std::int32_t x = 0; x < width; ++x) {
        const auto ux = static_cast<std::size_t>(x);
        const bool bit = (in[ux / 8] >> (7 - ux % 8) & 1) != 0;
        ASSERT_EQ(bitmap.get(x, 1), bit != invert) << width << " " << x;
      }
      std::vector<std::uint8_t> out(in.size());
      bitmap.get_row_bytes(1, out, invert);
      for (std::int32_t x = 0; x < width; ++x) {
        const auto ux = static_cast<std::size_t>(x);
        ASSERT_EQ(in[ux / 8] >> (7 - ux % 8) & 1,
                  out[ux / 8] >> (7 - ux % 8) & 1);
      }
    }
    EXPECT_EQ(bitmap.row(0).front(), 0U);
  }
}

TEST(Bitmap, CrcDependsOnPixelsOnly) {
  Bitmap a = *Bitmap::create(70, 3);
  Bitmap b = a;
  EXPECT_EQ(a.crc32(), b.crc32());
  b.set(69, 2, true);
  EXPECT_NE(a.crc32(), b.crc32());
  EXPECT_EQ(b.ink(), 1U);
  b.set(69, 2, false);
  EXPECT_EQ(a.crc32(), b.crc32());
}

}  // namespace
}  // namespace unstep
