#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/context.h"
#include "unstep/grid.h"

namespace unstep::codec {

/// How many vertices there are in square cells of three sizes, as far as
/// remembered: a newer cell replaces an older one at the same place.
class DensityGrid {
 public:
  DensityGrid() : DensityGrid(15) {}
  /// `bits`: log2 of the cells that are remembered.
  explicit DensityGrid(int bits)
      : bits_(bits), cells_(std::size_t{1} << bits) {}

  void add(Point at) {
    for (const int shift : {3, 5, 8}) {
      Cell& cell = cells_[place(key(shift, at.x >> shift, at.y >> shift))];
      const std::uint64_t k = key(shift, at.x >> shift, at.y >> shift);
      if (cell.key != k) cell = {k, 0};
      ++cell.count;
    }
  }

  /// The vertices in the cells from x = first, `size` units (a power of two)
  /// wide, that a point in row y is near; 0 above 2^16.
  [[nodiscard]] std::uint32_t count(std::int64_t first, std::int64_t size,
                                    std::int64_t y) const {
    if (size > 65536) return 0;
    const int shift = size >= 256 ? 8 : size >= 32 ? 5 : 3;
    const std::int64_t rows = shift == 8 ? 0 : 1;
    std::uint32_t sum = 0;
    for (std::int64_t c = first >> shift; c <= (first + size - 1) >> shift;
         ++c) {
      for (std::int64_t r = -rows; r <= rows; ++r) {
        const std::uint64_t k = key(shift, c, (y >> shift) + r);
        const Cell& cell = cells_[place(k)];
        if (cell.key == k) sum += cell.count;
      }
    }
    return sum;
  }

 private:
  struct Cell {
    std::uint64_t key = 0;
    std::uint32_t count = 0;
  };

  /// Never 0, so that an unused cell is no cell: |x|, |y| < 2^28.
  static std::uint64_t key(int shift, std::int64_t x, std::int64_t y) {
    return std::uint64_t{static_cast<std::uint32_t>(x) & 0x0fffffffU} << 32 |
           (static_cast<std::uint32_t>(y) & 0x0fffffffU) |
           static_cast<std::uint64_t>(shift) << 60;
  }
  [[nodiscard]] std::size_t place(std::uint64_t key) const {
    return static_cast<std::size_t>(mix(key, 0) * kGolden >> (64 - bits_));
  }

  int bits_;
  std::vector<Cell> cells_;
};

}  // namespace unstep::codec
