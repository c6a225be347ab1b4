#pragma once

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

/// Rows of path units: both ends belong to it.
struct RowRange {
  std::int64_t low = 0;
  std::int64_t high = 0;
};

/// The pairs of lines that meet otherwise than by touching in a point: they
/// cross, at a vertex or between, or lie on each other for a length. Lines
/// that follow one another in a path are not looked at. A pair may come more
/// than once. `closed[i]`: path i is a ring. Only lines that reach into
/// `rows`, sorted and apart from each other, are looked at.
///
/// Each line goes into the square cells that it reaches, a power of two wide,
/// `cell_size` or less at first and twice that until there are at most five
/// cells to a vertex, and is compared with the lines that are there. Time O(L)
/// for L lines that are short or sparse. Memory: 24 bytes per line, 8 per line
/// and cell that it reaches, 8 per cell.
///
/// Range: coordinates are within kMaxCoord, so an orientation, the difference
/// of two products of differences, is below 2^63.
std::vector<CrossingPair> find_crossings(std::span<const LineVertices> paths,
                                         const std::vector<bool>& closed,
                                         std::span<const RowRange> rows,
                                         std::int64_t cell_size);

/// True if two curves that meet at `at` change sides there, when the first
/// comes from `a_in` and goes on to `a_out`, the second likewise. False if
/// they leave in a common direction.
bool change_sides(Point at, Point a_in, Point a_out, Point b_in, Point b_out);

}  // namespace unstep::reverse
