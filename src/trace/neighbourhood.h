#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "unstep/bitmap.h"
#include "unstep/grid.h"

/// The eight neighbours of a pixel, one by one and of 64 pixels at once.
/// Everything beside the raster is paper.
namespace unstep::trace {

/// Clockwise as seen from north: n, ne, e, se, s, sw, w, nw. A pixel beside
/// another along a row or column has an even place.
inline constexpr std::array<Point, 8> kRing{
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

[[nodiscard]] inline bool pixel_at(const Bitmap& ink, Point at) {
  return at.x >= 0 && at.y >= 0 && at.x < ink.width() && at.y < ink.height() &&
         ink.get(at.x, at.y);
}

/// Bit i is the neighbour kRing[i].
[[nodiscard]] inline unsigned ring_of(const Bitmap& ink, Point at) {
  unsigned ring = 0;
  for (std::size_t i = 0; i < kRing.size(); ++i) {
    const Point p{at.x + kRing[i].x, at.y + kRing[i].y};
    if (pixel_at(ink, p)) ring |= 1U << i;
  }
  return ring;
}

/// How many pieces the neighbours have, ink 8-connected (the crossing number):
/// the places along a row or column that are paper with ink behind them,
/// clockwise. 0 if all those four are ink or there is no neighbour.
[[nodiscard]] constexpr int pieces(unsigned ring) {
  int count = 0;
  for (unsigned i = 0; i < 8; i += 2) {
    const unsigned turned = (ring | ring << 8) >> i;
    if ((turned & 1) == 0 && (turned & 6) != 0) ++count;
  }
  return count;
}

/// A pixel whose removal changes neither the pieces of ink nor the holes:
/// A. Rosenfeld, "Connectivity in digital pictures", J. ACM 17 (1970).
[[nodiscard]] constexpr bool is_simple(unsigned ring) {
  return pieces(ring) == 1;
}

/// The neighbours of the 64 pixels of one word, each as a word of their own.
struct WordRing {
  std::uint64_t n, ne, e, se, s, sw, w, nw;
};

[[nodiscard]] inline WordRing ring_of(const Bitmap& ink, std::int32_t y,
                                      std::size_t word) {
  struct Three {
    std::uint64_t left, here, right;
  };
  const auto of_row = [&](std::int32_t row) -> Three {
    if (row < 0 || row >= ink.height()) return {0, 0, 0};
    const auto words = ink.row(row);
    const std::uint64_t here = words[word];
    const std::uint64_t before = word > 0 ? words[word - 1] : 0;
    const std::uint64_t after = word + 1 < words.size() ? words[word + 1] : 0;
    return {here >> 1 | before << 63, here, here << 1 | after >> 63};
  };
  const Three up = of_row(y - 1);
  const Three row = of_row(y);
  const Three down = of_row(y + 1);
  return {up.here,   up.right,  row.right, down.right,
          down.here, down.left, row.left,  up.left};
}

/// Pixels of which the word says 1 in exactly one of the four.
[[nodiscard]] constexpr std::uint64_t exactly_one(std::uint64_t a,
                                                  std::uint64_t b,
                                                  std::uint64_t c,
                                                  std::uint64_t d) {
  const std::uint64_t two = (a & b) | (c & d) | ((a | b) & (c | d));
  return (a | b | c | d) & ~two;
}

/// ... in at least two of the four.
[[nodiscard]] constexpr std::uint64_t at_least_two(std::uint64_t a,
                                                   std::uint64_t b,
                                                   std::uint64_t c,
                                                   std::uint64_t d) {
  return (a & b) | (c & d) | ((a | b) & (c | d));
}

/// is_simple() of 64 pixels.
[[nodiscard]] constexpr std::uint64_t simple_pixels(const WordRing& p) {
  return exactly_one(~p.n & (p.ne | p.e), ~p.e & (p.se | p.s),
                     ~p.s & (p.sw | p.w), ~p.w & (p.nw | p.n));
}

/// Pixels with at least two neighbours.
[[nodiscard]] constexpr std::uint64_t inner_pixels(const WordRing& p) {
  return at_least_two(p.n, p.ne, p.e, p.se) |
         at_least_two(p.s, p.sw, p.w, p.nw) |
         ((p.n | p.ne | p.e | p.se) & (p.s | p.sw | p.w | p.nw));
}

}  // namespace unstep::trace
