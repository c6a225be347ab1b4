#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "codec/crack_map.h"

namespace unstep::codec {

/// The 40 cracks among 5 x 5 grid points around the point ahead of a walk,
/// turned so that the walk always looks the same way: bit i of a patch is the
/// same crack relative to the direction, whichever direction it is.
///
/// Relative places: f steps forward, r to the right. "Along" cracks lead from
/// (f, r) to (f + 1, r), f = -1..2, r = -2..2; "across" ones from (f, r) to
/// (f, r + 1), f = -1..3, r = -2..1.
namespace patch {

constexpr unsigned along(int f, int r) {
  return static_cast<unsigned>((f + 1) * 5 + r + 2);
}
constexpr unsigned across(int f, int r) {
  return 20U + static_cast<unsigned>((f + 1) * 4 + r + 2);
}
constexpr std::uint64_t bit(unsigned place) {
  return std::uint64_t{1} << place;
}

/// The crack that was just walked is always known and says nothing.
inline constexpr std::uint64_t kAll =
    ((std::uint64_t{1} << 40) - 1) & ~bit(along(-1, 0));

/// The cracks that bound the pixels ahead and beside.
inline constexpr std::uint64_t kNear =
    bit(along(0, 0)) | bit(along(1, 0)) | bit(along(0, 1)) | bit(along(0, -1)) |
    bit(along(1, 1)) | bit(along(1, -1)) | bit(along(-1, 1)) |
    bit(along(-1, -1)) | bit(across(0, 0)) | bit(across(0, -1)) |
    bit(across(1, 0)) | bit(across(1, -1)) | bit(across(0, 1)) |
    bit(across(0, -2)) | bit(across(-1, 0)) | bit(across(-1, -1)) |
    bit(across(1, 1)) | bit(across(1, -2));

/// The three cracks that may be walked next: bit t is set if the one of turn t
/// is known.
[[nodiscard]] constexpr unsigned ways(std::uint64_t patch) {
  static_assert(trace::kStraight == 0 && trace::kLeft == 1 &&
                trace::kRight == 2);
  return static_cast<unsigned>((patch >> along(0, 0) & 1) |
                               (patch >> across(0, -1) & 1) << 1 |
                               (patch >> across(0, 0) & 1) << 2);
}

namespace detail {

/// [direction][row][bits]: where the bits of a row of the raster go. Rows 0..4
/// are horizontal cracks (4 bits a row), 5..8 vertical ones (5 bits a row).
using Table = std::array<std::array<std::array<std::uint64_t, 32>, 9>, 4>;

/// The place of the crack with centre (x2, y2) / 2 from the middle of the
/// block, in the raster's frame; the middle is at f = 1.
constexpr unsigned place(int direction, int x2, int y2) {
  int f2 = x2;
  int r2 = y2;  // y down: east's right hand is south
  for (int d = 0; d < direction; ++d) {
    const int t = f2;
    f2 = r2;
    r2 = -t;
  }
  return (f2 & 1) != 0 ? along((f2 + 5) / 2 - 2, (r2 + 4) / 2 - 2)
                       : across((f2 + 4) / 2 - 1, (r2 + 5) / 2 - 3);
}

constexpr Table make_table() {
  Table table{};
  for (int d = 0; d < 4; ++d) {
    for (int row = 0; row < 9; ++row) {
      const int count = row < 5 ? 4 : 5;
      for (unsigned bits = 0; bits < (1U << count); ++bits) {
        std::uint64_t out = 0;
        for (int i = 0; i < count; ++i) {
          if ((bits >> (count - 1 - i) & 1) == 0) continue;
          const int x2 = row < 5 ? 2 * (i - 2) + 1 : 2 * (i - 2);
          const int y2 = row < 5 ? 2 * (row - 2) : 2 * (row - 7) + 1;
          out |= bit(place(d, x2, y2));
        }
        table[static_cast<std::size_t>(d)][static_cast<std::size_t>(row)]
             [bits] = out;
      }
    }
  }
  return table;
}

inline constexpr Table kTable = make_table();

}  // namespace detail

/// The patch around a point for a walk in `direction`.
[[nodiscard]] inline std::uint64_t at(const CrackMap& cracks,
                                      CrackMap::Address point,
                                      Quarter direction) {
  const auto& table = detail::kTable[static_cast<std::size_t>(direction)];
  std::uint64_t bits = 0;
  const CrackMap::Address middle = point + cracks.step(direction);
  CrackMap::Address first = middle - 2 * cracks.stride() - 2;
  for (std::size_t row = 0; row < 5; ++row, first += cracks.stride()) {
    bits |= table[row][cracks.window(first) >> 60];
  }
  first = middle + cracks.vertical() - 2 * cracks.stride() - 2;
  for (std::size_t row = 5; row < 9; ++row, first += cracks.stride()) {
    bits |= table[row][cracks.window(first) >> 59];
  }
  return bits;
}

}  // namespace patch
}  // namespace unstep::codec
