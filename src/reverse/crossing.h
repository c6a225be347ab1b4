#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reverse/tolerance_lines.h"

namespace unstep::reverse {

/// Line `line` of path `path`, from its vertex of that index to the next.
struct LineId {
  std::uint32_t path = 0;
  std::uint32_t line = 0;
  friend bool operator==(const LineId&, const LineId&) = default;
};

struct CrossingPair {
  LineId first;
  LineId second;
};

/// A rectangle of path units: its sides belong to it.
struct Box {
  std::int32_t low_x = 0;
  std::int32_t high_x = 0;
  std::int32_t low_y = 0;
  std::int32_t high_y = 0;

  static Box around(Point a, Point b) {
    return {std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y),
            std::max(a.y, b.y)};
  }
  void add(const Box& other) {
    low_x = std::min(low_x, other.low_x);
    high_x = std::max(high_x, other.high_x);
    low_y = std::min(low_y, other.low_y);
    high_y = std::max(high_y, other.high_y);
  }
  /// Without branches: which side is free is different each time.
  [[nodiscard]] bool meets(const Box& other) const {
    return (static_cast<int>(high_x >= other.low_x) &
            static_cast<int>(other.high_x >= low_x) &
            static_cast<int>(high_y >= other.low_y) &
            static_cast<int>(other.high_y >= low_y)) != 0;
  }
};

/// All there is.
inline constexpr Box kEverywhere{-kMaxCoord, kMaxCoord, -kMaxCoord, kMaxCoord};

/// The pairs of lines that meet otherwise than by touching in a point: they
/// cross, at a vertex or between, or lie on each other for a length. Lines
/// that follow one another in a path are not looked at. A pair may come more
/// than once. `closed[i]`: path i is a ring. Lines that do not reach into any
/// of `places` are looked at only if they are near one.
///
/// Each line goes into the square cells that it reaches, a power of two wide,
/// `cell_size` or less at first and twice that until there are at most five
/// cells to a line, and is compared with the lines that are there. Time O(L)
/// for L lines that are short or sparse. Memory: 24 bytes per line, 68 per cell
/// that lines reach and eight of them there, 8 per cell, 64 per place.
///
/// REQUIRES: `places` is not empty. Range: coordinates are within kMaxCoord, so
/// an orientation, the difference of two products of differences, is below
/// 2^63.
std::vector<CrossingPair> find_crossings(std::span<const LineVertices> paths,
                                         const std::vector<bool>& closed,
                                         std::span<const Box> places,
                                         std::int64_t cell_size);

/// True if two curves that meet at `at` change sides there, when the first
/// comes from `a_in` and goes on to `a_out`, the second likewise. False if
/// they leave in a common direction.
bool change_sides(Point at, Point a_in, Point a_out, Point b_in, Point b_out);

}  // namespace unstep::reverse
