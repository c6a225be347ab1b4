#include "trace/edge_noise.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "trace/neighbourhood.h"

namespace unstep::trace {
namespace {

constexpr std::size_t kLargestHole = 4;

template <class Use>
void for_each_pixel(std::uint64_t word, std::size_t w, std::int32_t y,
                    Use use) {
  while (word != 0) {
    const int bit = std::countl_zero(word);
    word &= ~(std::uint64_t{1} << (63 - bit));
    use(Point{static_cast<std::int32_t>(w * 64) + bit, y});
  }
}

/// Fills the hole that a paper pixel is in, if it is small.
void fill_hole(Bitmap& ink, Point at) {
  std::array<Point, kLargestHole + 1> hole{at};
  std::size_t size = 1;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < kRing.size(); k += 2) {
      const Point p{hole[i].x + kRing[k].x, hole[i].y + kRing[k].y};
      if (p.x < 0 || p.y < 0 || p.x >= ink.width() || p.y >= ink.height()) {
        return;
      }
      const auto end = hole.begin() + static_cast<std::ptrdiff_t>(size);
      if (ink.get(p.x, p.y) || std::find(hole.begin(), end, p) != end) continue;
      if (size == kLargestHole) return;
      hole[size++] = p;
    }
  }
  for (std::size_t i = 0; i < size; ++i) ink.set(hole[i].x, hole[i].y, true);
}

/// Pixels with ink on at least three of their four sides.
std::uint64_t mostly_enclosed(const WordRing& p) {
  return (p.n & p.s & (p.e | p.w)) | (p.e & p.w & (p.n | p.s));
}

/// Pixels of which at least five of the nine in and around them are ink.
std::uint64_t majority(std::uint64_t here, const WordRing& p) {
  struct Sum {
    std::uint64_t one, two;
  };
  const auto add = [](std::uint64_t a, std::uint64_t b, std::uint64_t c) {
    return Sum{a ^ b ^ c, (a & b) | (a & c) | (b & c)};
  };
  const Sum up = add(p.nw, p.n, p.ne);
  const Sum row = add(p.w, here, p.e);
  const Sum down = add(p.sw, p.s, p.se);
  const Sum ones = add(up.one, row.one, down.one);
  const Sum twos = add(up.two, row.two, down.two);
  // ones.one + 2 (ones.two + twos.one) + 4 twos.two
  const std::uint64_t two = ones.two ^ twos.one;
  const std::uint64_t four = ones.two & twos.one;
  const std::uint64_t eight = four & twos.two;
  return eight | ((four ^ twos.two) & (two | ones.one));
}

/// Pixels with ink in all eight directions, or with ink in one of them.
template <bool all>
void spread(const Bitmap& from, Bitmap& to) {
  for (std::int32_t y = 0; y < from.height(); ++y) {
    for (std::size_t w = 0; w < from.words_per_row(); ++w) {
      const std::uint64_t here = from.row(y)[w];
      const WordRing p = ring_of(from, y, w);
      const std::uint64_t edges =
          all ? p.n & p.e & p.s & p.w & p.ne & p.se & p.sw & p.nw & here
              : p.n | p.e | p.s | p.w | p.ne | p.se | p.sw | p.nw | here;
      const bool last = w + 1 == from.words_per_row();
      to.row(y)[w] = last ? edges & from.last_word_mask() : edges;
    }
  }
}

}  // namespace

Status smooth_edges(Bitmap& ink) {
  Result<Bitmap> near = Bitmap::create(ink.width(), ink.height());
  if (!near) return near.error();
  Result<Bitmap> changed = Bitmap::create(ink.width(), ink.height());
  if (!changed) return changed.error();
  spread<true>(ink, *changed);
  spread<false>(*changed, *near);
  spread<false>(*near, *changed);
  spread<false>(*changed, *near);
  const auto for_each_word = [&](auto use) {
    for (std::int32_t y = 0; y < ink.height(); ++y) {
      for (std::size_t w = 0; w < ink.words_per_row(); ++w) {
        if (near->row(y)[w] != 0) use(y, w);
      }
    }
  };
  for_each_word([&](std::int32_t y, std::size_t w) {
    const std::uint64_t holes =
        mostly_enclosed(ring_of(ink, y, w)) & ~ink.row(y)[w] & near->row(y)[w];
    for_each_pixel(holes, w, y, [&](Point at) {
      if (!ink.get(at.x, at.y)) fill_hole(ink, at);
    });
  });
  for_each_word([&](std::int32_t y, std::size_t w) {
    const std::uint64_t here = ink.row(y)[w];
    const std::uint64_t most = majority(here, ring_of(ink, y, w));
    changed->row(y)[w] = (most ^ here) & near->row(y)[w];
  });
  for_each_word([&](std::int32_t y, std::size_t w) {
    for_each_pixel(changed->row(y)[w], w, y, [&](Point at) {
      const unsigned ring = ring_of(ink, at);
      if (is_simple(ring) || ring == 0) {
        ink.set(at.x, at.y, !ink.get(at.x, at.y));
      }
    });
  });
  return {};
}

}  // namespace unstep::trace
