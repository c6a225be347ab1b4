#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "grid/row_distances.h"
#include "trace/neighbourhood.h"
#include "unit/container_testing.h"
#include "unstep/deviation.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

using testing::ink_of;

Bitmap random_ink(std::int32_t width, std::int32_t height, unsigned percent,
                  int smoothing, std::uint32_t seed) {
  std::mt19937 random(seed);
  Bitmap ink = *Bitmap::create(width, height);
  for (std::int32_t y = 0; y < height; ++y) {
    for (std::int32_t x = 0; x < width; ++x) {
      ink.set(x, y, random() % 100 < percent);
    }
  }
  for (int i = 0; i < smoothing; ++i) {
    const Bitmap before = ink;
    for (std::int32_t y = 0; y < height; ++y) {
      for (std::int32_t x = 0; x < width; ++x) {
        const int near = std::popcount(trace::ring_of(before, {x, y})) +
                         (before.get(x, y) ? 1 : 0);
        ink.set(x, y, near >= 5);
      }
    }
  }
  return ink;
}

/// Pieces of ink (8-connected) and of paper (4-connected, with what is around
/// the raster), by flooding.
std::pair<int, int> pieces_by_flooding(const Bitmap& ink) {
  const std::int32_t w = ink.width() + 2;
  const std::int32_t h = ink.height() + 2;
  std::vector<bool> seen(static_cast<std::size_t>(w) *
                         static_cast<std::size_t>(h));
  const auto at = [&](std::int32_t x, std::int32_t y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(w) +
           static_cast<std::size_t>(x);
  };
  const auto inked = [&](Point p) {
    return trace::pixel_at(ink, {p.x - 1, p.y - 1});
  };
  std::pair<int, int> pieces;
  for (std::int32_t y = 0; y < h; ++y) {
    for (std::int32_t x = 0; x < w; ++x) {
      if (seen[at(x, y)]) continue;
      const bool colour = inked({x, y});
      ++(colour ? pieces.first : pieces.second);
      std::vector<Point> open{{x, y}};
      seen[at(x, y)] = true;
      while (!open.empty()) {
        const Point p = open.back();
        open.pop_back();
        for (std::size_t i = 0; i < 8; i += colour ? 1 : 2) {
          const Point q{p.x + trace::kRing[i].x, p.y + trace::kRing[i].y};
          if (q.x < 0 || q.y < 0 || q.x >= w || q.y >= h ||
              seen[at(q.x, q.y)] || inked(q) != colour) {
            continue;
          }
          seen[at(q.x, q.y)] = true;
          open.push_back(q);
        }
      }
    }
  }
  return pieces;
}

/// Euler number of 8-connected ink by counting squares of four pixels: S. Gray,
/// "Local properties of binary images in two dimensions", 1971.
std::int64_t euler_number(const Bitmap& ink) {
  std::int64_t sum = 0;
  for (std::int32_t y = -1; y < ink.height(); ++y) {
    for (std::int32_t x = -1; x < ink.width(); ++x) {
      const bool a = trace::pixel_at(ink, {x, y});
      const bool b = trace::pixel_at(ink, {x + 1, y});
      const bool c = trace::pixel_at(ink, {x, y + 1});
      const bool d = trace::pixel_at(ink, {x + 1, y + 1});
      const int count = a + b + c + d;
      if (count == 1) ++sum;
      if (count == 3) --sum;
      if (count == 2 && a == d) sum -= 2;
    }
  }
  return sum / 4;
}

void expect_thin(const Bitmap& ink, const std::string& name) {
  Bitmap thinned = ink;
  ASSERT_TRUE(thin(thinned)) << name;
  EXPECT_EQ(pieces_by_flooding(thinned), pieces_by_flooding(ink)) << name;
  EXPECT_EQ(euler_number(thinned), euler_number(ink)) << name;
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    for (std::int32_t x = 0; x < ink.width(); ++x) {
      if (!thinned.get(x, y)) continue;
      EXPECT_TRUE(ink.get(x, y)) << name;
      const unsigned ring = trace::ring_of(thinned, {x, y});
      EXPECT_TRUE(std::popcount(ring) < 2 || !trace::is_simple(ring))
          << name << ": " << x << ", " << y << " could go";
    }
  }
}

TEST(Thinning, APixelIsSimpleIfItsNeighboursAreOnePieceBesideItsPaper) {
  for (unsigned ring = 0; ring < 256; ++ring) {
    Bitmap with = *Bitmap::create(3, 3);
    for (std::size_t i = 0; i < 8; ++i) {
      with.set(1 + trace::kRing[i].x, 1 + trace::kRing[i].y,
               (ring >> i & 1) != 0);
    }
    const Bitmap without = with;
    with.set(1, 1, true);
    const bool kept = pieces_by_flooding(with) == pieces_by_flooding(without);
    EXPECT_EQ(trace::is_simple(ring), kept) << ring;
    const trace::WordRing words = trace::ring_of(with, 1, 0);
    EXPECT_EQ((trace::simple_pixels(words) >> 62 & 1) != 0, kept) << ring;
    EXPECT_EQ((trace::inner_pixels(words) >> 62 & 1) != 0,
              std::popcount(ring) >= 2)
        << ring;
  }
}

TEST(Thinning, KeepsPiecesAndHolesOfRandomInk) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const auto width = static_cast<std::int32_t>(1 + seed * 37 % 150);
    const auto height = static_cast<std::int32_t>(1 + seed * 23 % 60);
    const Bitmap ink = random_ink(width, height, 30 + seed % 50,
                                  static_cast<int>(seed % 4), seed);
    expect_thin(ink, "seed " + std::to_string(seed));
  }
}

TEST(Thinning, KeepsPiecesAndHolesOfEverySmallBitmap) {
  for (unsigned bits = 0; bits < 1U << 12; ++bits) {
    Bitmap ink = *Bitmap::create(4, 3);
    for (int i = 0; i < 12; ++i) ink.set(i % 4, i / 4, (bits >> i & 1) != 0);
    expect_thin(ink, "bits " + std::to_string(bits));
  }
}

TEST(Thinning, LeavesAThinLineAloneAndMakesABarALine) {
  const Bitmap line = ink_of({"........", ".######.", "........"});
  Bitmap thinned = line;
  ASSERT_TRUE(thin(thinned));
  EXPECT_EQ(thinned, line);
  Bitmap bar = *Bitmap::create(200, 9);
  for (std::int32_t y = 0; y < 9; ++y) {
    for (std::int32_t x = 0; x < 200; ++x) bar.set(x, y, true);
  }
  ASSERT_TRUE(thin(bar));
  for (std::int32_t x = 10; x < 190; ++x) {
    for (std::int32_t y = 0; y < 9; ++y) EXPECT_EQ(bar.get(x, y), y == 4) << x;
  }
}

TEST(Thinning, StopsWhenAskedWithTheSameTopology) {
  const Bitmap ink = random_ink(120, 80, 55, 3, 7);
  Bitmap thinned = ink;
  int calls = 0;
  const Status status =
      thin(thinned, [&](std::uint64_t, std::uint64_t) { return ++calls < 3; });
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::cancelled);
  EXPECT_EQ(pieces_by_flooding(thinned), pieces_by_flooding(ink));
}

TEST(RowDistances, AreThoseToTheNearestPixelOfAll) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const Bitmap ink =
        random_ink(static_cast<std::int32_t>(1 + seed * 13),
                   static_cast<std::int32_t>(25 - seed * 2), seed * 9, 0, seed);
    for (const auto to : {RowDistances::To::ink, RowDistances::To::paper}) {
      RowDistances distances(ink, to);
      // Every other row: rows may be passed over.
      for (std::int32_t y = 0; y < ink.height(); y += 2) {
        const auto row = distances.row(y);
        for (std::int32_t x = 0; x < ink.width(); ++x) {
          std::int64_t best = RowDistances::kNone;
          for (std::int32_t v = -1; v <= ink.height(); ++v) {
            for (std::int32_t u = -1; u <= ink.width(); ++u) {
              if (trace::pixel_at(ink, {u, v}) != (to == RowDistances::To::ink))
                continue;
              const std::int64_t dx = u - x;
              const std::int64_t dy = v - y;
              best = std::min(best, dx * dx + dy * dy);
            }
          }
          EXPECT_EQ(row[static_cast<std::size_t>(x)], best)
              << seed << ": " << x << ", " << y;
        }
      }
    }
  }
}

TEST(InkDistance, IsTheLargestWayFromOneInkToTheOther) {
  const Bitmap a = ink_of({"#.....", "......", "......"});
  const Bitmap b = ink_of({"#.....", "......", "....#."});
  const Result<InkDistance> found = measure_ink(a, b);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->of_a.square, 0);
  EXPECT_EQ(found->of_b.square, 20);
  EXPECT_EQ(found->worst().at, (Point{4, 2}));
  EXPECT_EQ(found->ink, 1U);
  EXPECT_EQ(found->only_a, 0U);
  EXPECT_EQ(found->only_b, 1U);
  EXPECT_FALSE(measure_ink(a, *Bitmap::create(6, 3)));
  EXPECT_FALSE(measure_ink(a, *Bitmap::create(5, 3)));
  EXPECT_TRUE(measure_ink(*Bitmap::create(6, 3), *Bitmap::create(6, 3)));
}

}  // namespace
}  // namespace unstep
