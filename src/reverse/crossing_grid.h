#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

#include "reverse/crossing.h"

namespace unstep::reverse {

/// A line of a path, by its surroundings.
struct Line {
  Box box;
  LineId id;
};

/// Square cells over all paths, a power of two wide, not many more than there
/// are lines.
struct Grid {
  std::int64_t low_x = 0;
  std::int64_t low_y = 0;
  std::int64_t high_x = 0;
  int shift = 0;
  std::int64_t columns = 1;
  std::int64_t rows = 1;

  [[nodiscard]] std::int64_t column(std::int64_t x) const {
    return (x - low_x) >> shift;
  }
  [[nodiscard]] std::int64_t row(std::int64_t y) const {
    return (y - low_y) >> shift;
  }
  [[nodiscard]] std::int64_t end_of_row(std::int64_t row) const {
    return low_y + ((row + 1) << shift);
  }

  /// What of a box is in the cell: its columns, of 16 that are as many units
  /// wide as needed, from bit 0 on, its rows from bit 16 on. Two boxes that
  /// meet in a cell have a common column and a common row there.
  /// REQUIRES: some of it is.
  [[nodiscard]] std::uint32_t sixteenths(const Box& box, std::int64_t row,
                                         std::int64_t column) const {
    const std::int64_t x = low_x + (column << shift);
    const std::int64_t y = low_y + (row << shift);
    return range(box.low_x - x, box.high_x - x) |
           range(box.low_y - y, box.high_y - y) << 16;
  }
  [[nodiscard]] std::uint32_t range(std::int64_t low, std::int64_t high) const {
    const std::int64_t last = (std::int64_t{1} << shift) - 1;
    const int narrow = std::max(shift - 4, 0);
    const std::int64_t first_bit = std::max<std::int64_t>(low, 0) >> narrow;
    const std::int64_t last_bit = std::min(high, last) >> narrow;
    return (2U << last_bit) - (1U << first_bit);
  }

  static Grid around(std::span<const Line> lines, std::int64_t cell) {
    const int shift =
        static_cast<int>(std::bit_width(static_cast<std::uint64_t>(cell))) - 1;
    if (lines.empty()) return {};
    Box box = lines.front().box;
    for (const Line& line : lines) box.add(line.box);
    const auto count = static_cast<std::int64_t>(lines.size());
    Grid grid{box.low_x, box.low_y, box.high_x, shift, 1, 1};
    for (;; ++grid.shift) {
      grid.columns = grid.column(box.high_x) + 1;
      grid.rows = grid.row(box.high_y) + 1;
      if (grid.columns <= 4 * count / grid.rows + 1) return grid;
    }
  }
};

/// Calls `visit(row, column)` for the cells of a box if there are at most four;
/// else false.
template <class Visit>
bool enter_small(const Grid& grid, const Box& box, const Visit& visit) {
  const std::int64_t left = grid.column(box.low_x);
  const std::int64_t right = grid.column(box.high_x);
  const std::int64_t top = grid.row(box.low_y);
  const std::int64_t bottom = grid.row(box.high_y);
  if (right - left > 1 || bottom - top > 1) return false;
  for (std::int64_t row = top; row <= bottom; ++row) {
    for (std::int64_t column = left; column <= right; ++column) {
      visit(row, column);
    }
  }
  return true;
}

/// Calls `visit(row, column)` for every cell that the line may reach, some
/// beside it too.
template <class Visit>
void for_cells(const Grid& grid, const Box& line, const LineEnds& ends,
               const Visit& visit) {
  const std::int64_t first = grid.row(line.low_y);
  const std::int64_t last = grid.row(line.high_y);
  const auto visit_row = [&](std::int64_t row, std::int64_t low,
                             std::int64_t high) {
    const std::int64_t end = grid.column(high);
    for (std::int64_t c = grid.column(low); c <= end; ++c) {
      visit(row, c);
    }
  };
  if (first == last || grid.column(line.low_x) == grid.column(line.high_x)) {
    for (std::int64_t row = first; row <= last; ++row) {
      visit_row(row, line.low_x, line.high_x);
    }
    return;
  }
  const bool down = ends.a.y <= ends.b.y;
  const Point a = down ? ends.a : ends.b;
  const Point b = down ? ends.b : ends.a;
  const std::int64_t dx = std::int64_t{b.x} - a.x;
  const std::int64_t dy = std::int64_t{b.y} - a.y;
  std::int64_t from = a.x;
  for (std::int64_t row = first; row <= last; ++row) {
    // Where it leaves the row, to within a unit; dx * (y - a.y) < 2^62.
    std::int64_t to = b.x;
    if (row < last) to = a.x + dx * (grid.end_of_row(row) - a.y) / dy;
    visit_row(row, std::max(std::min(from, to) - 1, grid.low_x),
              std::min(std::max(from, to) + 1, grid.high_x));
    from = to;
  }
}

}  // namespace unstep::reverse
