#include "codec/shape_coder.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "codec/shape_finder.h"
#include "codec/shape_matcher.h"
#include "unit/container_testing.h"

namespace unstep::codec {
namespace {

using testing::ink_of;
using testing::random_ink;
using Bytes = std::vector<std::uint8_t>;

constexpr DecodeLimits kLimits{};

/// Whether a revision of coder 2 brings back those rows, whatever the estimate
/// says of it.
Bytes expect_round_trip_by(std::uint8_t revision, const Bitmap& ink,
                           std::int32_t first, std::int32_t rows) {
  const auto shapes = match_shapes(ink, first, rows);
  const Result<Bytes> payload =
      encode_shapes(ink, first, rows, revision, shapes, {});
  EXPECT_TRUE(payload);
  Bitmap decoded = *Bitmap::create(ink.width(), ink.height());
  const Status done =
      decode_shapes(*payload, decoded, first, rows, revision, kLimits, {});
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

/// All do; returns what the standard one made.
Bytes expect_round_trip(const Bitmap& ink, std::int32_t first,
                        std::int32_t rows) {
  expect_round_trip_by(kShapesDeep, ink, first, rows);
  return expect_round_trip_by(kShapesMixed, ink, first, rows);
}

void expect_round_trip(const Bitmap& ink) {
  expect_round_trip(ink, 0, ink.height());
}

/// Letters of a made-up alphabet in lines, their outlines roughened.
Bitmap page_of_text(std::int32_t width, std::int32_t height, unsigned seed,
                    unsigned roughness) {
  std::mt19937 random(seed);
  std::vector<Bitmap> letters;
  for (unsigned i = 0; i < 12; ++i) {
    const auto w = static_cast<std::int32_t>(5 + random() % 9);
    Bitmap letter = *Bitmap::create(w, 12);
    for (std::int32_t y = 0; y < 12; ++y) letter.set(w / 2, y, true);
    for (int bar = 0; bar < 3; ++bar) {
      const auto y = static_cast<std::int32_t>(random() % 11);
      for (std::int32_t x = 0; x < w; ++x) {
        letter.set(x, y, true);
        letter.set(x, y + 1, true);
      }
    }
    letters.push_back(letter);
  }
  Bitmap page = *Bitmap::create(width, height);
  for (std::int32_t top = 3; top + 16 < height; top += 20) {
    for (std::int32_t left = 4; left + 16 < width;) {
      const Bitmap& letter = letters[random() % letters.size()];
      for (std::int32_t y = 0; y < letter.height(); ++y) {
        for (std::int32_t x = 0; x < letter.width(); ++x) {
          const bool flip = roughness != 0 && random() % roughness == 0;
          if (letter.get(x, y) != flip) page.set(left + x, top + y, true);
        }
      }
      left += letter.width() + 2 + static_cast<std::int32_t>(random() % 2) * 9;
    }
  }
  return page;
}

TEST(Shapes, BringBackAnyInk) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto width = static_cast<std::int32_t>(1 + seed * 37 % 300);
    const auto height = static_cast<std::int32_t>(1 + seed * 11 % 70);
    expect_round_trip(random_ink(width, height, seed));
  }
}

TEST(Shapes, BringBackText) {
  for (const unsigned roughness : {0U, 200U, 40U, 10U}) {
    SCOPED_TRACE("roughness " + std::to_string(roughness));
    expect_round_trip(page_of_text(333, 120, roughness, roughness));
  }
}

TEST(Shapes, BringBackTheSmallestAndTheLargest) {
  expect_round_trip(*Bitmap::create(1, 1));
  expect_round_trip(ink_of({"#"}));
  for (const std::int32_t side : {63, 64, 65, 127, 128, 192, 255, 256, 257}) {
    SCOPED_TRACE("side " + std::to_string(side));
    Bitmap ink = *Bitmap::create(2 * side + 3, side);
    for (std::int32_t i = 0; i < side; ++i) {
      for (const std::int32_t left : {0, side + 3}) {
        ink.set(left + i, i, true);
        ink.set(left + side - 1 - i, i, true);
        ink.set(left, i, true);
        ink.set(left + side - 1, i, true);
      }
    }
    expect_round_trip(ink);
  }
}

TEST(Shapes, AreCodedWithinTheirBandOnly) {
  const Bitmap ink = page_of_text(200, 90, 7, 50);
  expect_round_trip(ink, 17, 41);
  expect_round_trip(ink, 0, 1);
  expect_round_trip(ink, 89, 1);
}

TEST(Shapes, ThatAreTheSameCostLittle) {
  const Bitmap once = page_of_text(640, 23, 3, 0);
  const Bitmap often = page_of_text(640, 400, 3, 0);
  const std::size_t one = expect_round_trip(once, 0, 23).size();
  const std::size_t all = expect_round_trip(often, 0, 400).size();
  EXPECT_LT(all, one + 19 * one / 2);
}

TEST(Shapes, AreNotUsedWhereNothingRepeats) {
  EXPECT_TRUE(find_shapes(random_ink(300, 200, 1), 0, 200, kShapesPay).empty());
  EXPECT_TRUE(find_shapes(*Bitmap::create(50, 50), 0, 50, kShapesPay).empty());
  EXPECT_FALSE(
      find_shapes(page_of_text(640, 400, 3, 30), 0, 400, kShapesPay).empty());
}

TEST(Shapes, AreJudgedAgainAsMoreOfThemCome) {
  // More than 2048 on either page: some of the looks at 1024 and later.
  EXPECT_GT(
      find_shapes(page_of_text(1300, 800, 3, 30), 0, 800, kShapesPay).size(),
      2048U);
  const Bitmap noise = random_ink(1100, 1100, 1);
  EXPECT_GT(match_shapes(noise, 0, 1100).size(), 2048U);
  EXPECT_TRUE(find_shapes(noise, 0, 1100, kShapesPay).empty());
}

TEST(Shapes, OfADamagedPayloadAreRefusedOrOther) {
  const Bitmap ink = page_of_text(160, 60, 5, 40);
  const Bytes payload = expect_round_trip(ink, 0, 60);
  const auto decodes_to_it = [&](const Bytes& bytes) {
    Bitmap decoded = *Bitmap::create(160, 60);
    return decode_shapes(bytes, decoded, 0, 60, 0, kLimits, {}) &&
           decoded == ink;
  };
  for (std::size_t cut = 0; cut < payload.size(); ++cut) {
    EXPECT_FALSE(decodes_to_it(Bytes(
        payload.begin(), payload.begin() + static_cast<std::ptrdiff_t>(cut))))
        << "cut at " << cut;
  }
  for (std::size_t bit = 0; bit < payload.size() * 8; bit += 7) {
    Bytes flipped = payload;
    flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    EXPECT_FALSE(decodes_to_it(flipped)) << "bit " << bit;
  }
}

TEST(Shapes, RefuseMoreMemoryThanAllowed) {
  DecodeLimits limits;
  limits.max_memory = 1000;
  Bitmap ink = *Bitmap::create(8, 8);
  const Status refused = decode_shapes(Bytes{}, ink, 0, 8, 0, limits, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::limit_exceeded);
}

TEST(Shapes, CountTheMemoryOfWhatTheyRemember) {
  // So large that the models of shapes need more than the contours do.
  const Bitmap ink = page_of_text(1300, 800, 3, 8);
  const auto shapes = match_shapes(ink, 0, 800);
  ASSERT_GT(shapes.size(), 1000U);
  const Result<Bytes> payload = encode_shapes(ink, 0, 800, 0, shapes, {});
  ASSERT_TRUE(payload);
  const std::uint64_t models = shape_memory(0, 1300, 800);
  for (const std::uint64_t more : {0U, 100'000U, 5'000'000U}) {
    DecodeLimits limits;
    limits.max_memory = models + more;
    Bitmap decoded = *Bitmap::create(1300, 800);
    const Status done = decode_shapes(*payload, decoded, 0, 800, 0, limits, {});
    EXPECT_EQ(bool{done}, more == 5'000'000) << more;
    if (!done) {
      EXPECT_EQ(done.error().code, ErrorCode::limit_exceeded);
    }
  }
}

/// `count` shapes of the largest size in one place, all the same or all but
/// their last pixel.
std::vector<PlacedShape> pile(std::size_t count, bool same) {
  std::vector<PlacedShape> shapes(count);
  for (std::size_t i = 0; i < count; ++i) {
    shapes[i].refers = i > 0;
    shapes[i].reference =
        same || i == 0 ? 0 : static_cast<std::uint32_t>(i - 1);
    shapes[i].glyph = Glyph(kMaxShapeSide, kMaxShapeSide);
    shapes[i].glyph.row(0)[0] = 1;
    const auto other = static_cast<std::int32_t>(i % 200);
    if (!same) shapes[i].glyph.row(kMaxShapeSide - 1 - other)[0] |= 2;
  }
  return shapes;
}

TEST(Shapes, CannotAskForMoreWorkThanThePageIsWorth) {
  // 4 x 300 x 300 + 65536 pixels of room, each shape takes 255 x 255 + 64.
  const Bitmap ink = *Bitmap::create(300, 300);
  for (const bool same : {true, false}) {
    EXPECT_TRUE(encode_shapes(ink, 0, 300, 0, pile(6, same), {}));
    const auto refused = encode_shapes(ink, 0, 300, 0, pile(7, same), {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::corrupt);
  }
}

TEST(Shapes, TellProgressAndCanBeCancelled) {
  const Bitmap ink = *Bitmap::create(600, 600);
  const auto shapes = pile(20, false);
  const Result<Bytes> payload = encode_shapes(ink, 0, 600, 0, shapes, {});
  ASSERT_TRUE(payload);
  for (const int most : {0, 4, 8}) {
    int heard = 0;
    const BlockProgress patient = [&](std::uint64_t done) {
      EXPECT_LE(done, 300U);
      return heard++ < most;
    };
    Bitmap decoded = *Bitmap::create(600, 600);
    const Status done =
        decode_shapes(*payload, decoded, 0, 600, 0, kLimits, patient);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::cancelled);
    EXPECT_EQ(heard, most + 1);
    heard = 0;
    const auto encoded = encode_shapes(ink, 0, 600, 0, shapes, patient);
    ASSERT_FALSE(encoded);
    EXPECT_EQ(encoded.error().code, ErrorCode::cancelled);
  }
}

TEST(Shapes, OfAPageAreHalfOfItsProgress) {
  const Bitmap ink = page_of_text(640, 400, 3, 8);
  const auto shapes = match_shapes(ink, 0, 400);
  std::uint64_t last = 0;
  const BlockProgress progress = [&](std::uint64_t done) {
    EXPECT_LE(done, 400U);
    EXPECT_GE(done + 20, last) << "lines of text go back a little at most";
    last = done;
    return true;
  };
  ASSERT_TRUE(encode_shapes(ink, 0, 400, 0, shapes, progress));
  EXPECT_GT(last, 380U);
}

/// By flooding pixel after pixel.
std::vector<std::int64_t> sizes_by_flood(Bitmap ink) {
  std::vector<std::int64_t> sizes;
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    for (std::int32_t x = 0; x < ink.width(); ++x) {
      if (!ink.get(x, y)) continue;
      std::vector<std::pair<std::int32_t, std::int32_t>> open{{x, y}};
      ink.set(x, y, false);
      std::int64_t size = 0;
      while (!open.empty()) {
        const auto [px, py] = open.back();
        open.pop_back();
        ++size;
        for (std::int32_t v = py - 1; v <= py + 1; ++v) {
          for (std::int32_t u = px - 1; u <= px + 1; ++u) {
            const bool inside =
                u >= 0 && v >= 0 && u < ink.width() && v < ink.height();
            if (!inside || !ink.get(u, v)) continue;
            ink.set(u, v, false);
            open.emplace_back(u, v);
          }
        }
      }
      sizes.push_back(size);
    }
  }
  return sizes;
}

TEST(Components, AreThoseOfAFlood) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Bitmap ink =
        random_ink(static_cast<std::int32_t>(60 + seed * 7), 40, seed);
    std::vector<std::int64_t> found;
    Bitmap together = *Bitmap::create(ink.width(), ink.height());
    for (const Component& part : find_components(ink, 0, 40, 100'000)) {
      found.push_back(part.pixels);
      if (part.width() > kMaxShapeSide) continue;
      const Glyph glyph = cut_out(ink, 0, part);
      std::int64_t pixels = 0;
      for (std::int32_t y = 0; y < glyph.height; ++y) {
        for (std::int32_t x = 0; x < glyph.width; ++x) {
          if (!glyph.get(x, y)) continue;
          ++pixels;
          EXPECT_TRUE(ink.get(part.x + x, part.y + y));
          EXPECT_FALSE(together.get(part.x + x, part.y + y));
          together.set(part.x + x, part.y + y, true);
        }
      }
      EXPECT_EQ(pixels, part.pixels);
    }
    EXPECT_EQ(found, sizes_by_flood(ink));
  }
}

TEST(Components, StopWhereThereAreTooMany) {
  EXPECT_TRUE(find_components(random_ink(200, 200, 1), 0, 200, 10).empty());
}

}  // namespace
}  // namespace unstep::codec
