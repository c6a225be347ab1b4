#include "machine/ink_distance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace unstep::machine {
namespace {

bool ink_at(const Bitmap& page, std::int32_t x, std::int32_t y) {
  return x >= 0 && y >= 0 && x < page.width() && y < page.height() &&
         page.get(x, y);
}

/// The square of the distance to the nearest ink, kReach^2 if there is none
/// nearer: squares of points, ring by ring.
std::int32_t nearest(const Bitmap& page, std::int32_t x, std::int32_t y) {
  constexpr std::int32_t kReach = InkDistance::kReach;
  std::int32_t best = kReach * kReach;
  for (std::int32_t r = 1; r * r < best; ++r) {
    for (std::int32_t i = -r; i <= r; ++i) {
      const std::int32_t square = r * r + i * i;
      if (square >= best) continue;
      if (ink_at(page, x + i, y - r) || ink_at(page, x + i, y + r) ||
          ink_at(page, x - r, y + i) || ink_at(page, x + r, y + i))
        best = square;
    }
  }
  return best;
}

/// Adds the way from the ink of `a` to that of `b`; returns the squares.
double add_way(const Bitmap& a, const Bitmap& b, InkDistance& sum) {
  constexpr std::int32_t kReach = InkDistance::kReach;
  double squares = 0;
  for (std::int32_t y = 0; y < a.height(); ++y) {
    for (std::size_t i = 0; i < a.words_per_row(); ++i) {
      std::uint64_t only = a.row(y)[i] & ~b.row(y)[i];
      sum.differing += static_cast<std::uint64_t>(std::popcount(only));
      while (only != 0) {
        const int bit = std::countl_zero(only);
        only &= ~(std::uint64_t{1} << (63 - bit));
        const std::int32_t square =
            nearest(b, static_cast<std::int32_t>(i * 64) + bit, y);
        sum.lost += square == kReach * kReach;
        sum.worst = std::max(sum.worst, std::sqrt(double(square)));
        squares += square;
      }
    }
  }
  return squares;
}

}  // namespace

InkDistance ink_distance(const Bitmap& a, const Bitmap& b) {
  InkDistance distance;
  const double squares = add_way(a, b, distance) + add_way(b, a, distance);
  const auto points = static_cast<double>(a.ink() + b.ink());
  if (points > 0) distance.rms = std::sqrt(squares / points);
  return distance;
}

}  // namespace unstep::machine
