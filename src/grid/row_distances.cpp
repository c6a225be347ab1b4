#include "grid/row_distances.h"

#include <algorithm>
#include <cstddef>

namespace unstep {

RowDistances::RowDistances(const Bitmap& pixels, To to)
    : pixels_(pixels),
      to_(to),
      above_(static_cast<std::size_t>(pixels.width()), -1),
      below_(static_cast<std::size_t>(pixels.width()), -1),
      column_(static_cast<std::size_t>(pixels.width())),
      squares_(static_cast<std::size_t>(pixels.width())) {}

std::span<const std::int64_t> RowDistances::row(std::int32_t y) {
  for (; passed_ <= y; ++passed_) pass(passed_);
  look_down(y);
  envelope();
  return squares_;
}

void RowDistances::pass(std::int32_t y) {
  const auto words = pixels_.row(y);
  const std::uint64_t flip = to_ == To::ink ? 0 : ~std::uint64_t{0};
  for (std::size_t w = 0; w < words.size(); ++w) {
    const std::uint64_t bits = words[w] ^ flip;
    const std::size_t first = w * 64;
    const std::size_t end = std::min(first + 64, above_.size());
    if (bits == ~std::uint64_t{0}) {
      std::fill(above_.begin() + static_cast<std::ptrdiff_t>(first),
                above_.begin() + static_cast<std::ptrdiff_t>(end), y);
    } else if (bits != 0) {
      for (std::size_t x = first; x < end; ++x) {
        if ((bits >> (63 - x % 64) & 1) != 0) above_[x] = y;
      }
    }
  }
}

/// Each column is walked down once in all.
void RowDistances::look_down(std::int32_t y) {
  const std::int32_t height = pixels_.height();
  const bool edges = to_ == To::paper;
  for (std::size_t x = 0; x < column_.size(); ++x) {
    std::int32_t down = std::max(below_[x], y);
    while (down < height && !wanted(x, down)) ++down;
    below_[x] = down;
    const std::int64_t none = std::int64_t{1} << 31;
    const std::int64_t up =
        above_[x] >= 0 || edges ? std::int64_t{y} - above_[x] : none;
    const std::int64_t under =
        down < height || edges ? std::int64_t{down} - y : none;
    const std::int64_t least = std::min(up, under);
    column_[x] = least == none ? kNone : least * least;
  }
}

void RowDistances::envelope() {
  bows_.clear();
  const auto width = static_cast<std::int64_t>(column_.size());
  const auto add = [&](std::int64_t column, std::int64_t square) {
    if (square == kNone) return;
    while (!bows_.empty()) {
      const Bow& last = bows_.back();
      // The first x where the new one is lower: sums are below 2^62.
      const std::int64_t rise =
          column * column - last.column * last.column + square - last.square;
      const std::int64_t run = 2 * (column - last.column);
      const std::int64_t from =
          rise < 0 ? -((-rise) / run) : (rise + run - 1) / run;
      if (from > last.from) {
        if (from < width) bows_.push_back({column, square, from});
        return;
      }
      bows_.pop_back();
    }
    bows_.push_back({column, square, 0});
  };
  if (to_ == To::paper) add(-1, 0);
  for (std::int64_t x = 0; x < width; ++x) {
    add(x, column_[static_cast<std::size_t>(x)]);
  }
  if (to_ == To::paper) add(width, 0);
  if (bows_.empty()) {
    std::ranges::fill(squares_, kNone);
    return;
  }
  std::size_t at = 0;
  for (std::int64_t x = 0; x < width; ++x) {
    while (at + 1 < bows_.size() && bows_[at + 1].from <= x) ++at;
    const std::int64_t along = x - bows_[at].column;
    squares_[static_cast<std::size_t>(x)] = along * along + bows_[at].square;
  }
}

}  // namespace unstep
