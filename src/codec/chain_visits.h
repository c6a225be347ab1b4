#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "unstep/grid.h"

namespace unstep::codec {

namespace detail {

/// Where the points of the square ring of radius r around (3, 3) are in a
/// window of 8 x 8 points, counter-clockwise from the east.
template <int r>
constexpr std::array<std::uint8_t, std::size_t{8} * r> make_ring() {
  std::array<std::uint8_t, std::size_t{8} * r> ring{};
  int x = r;
  int y = 0;
  for (std::uint8_t& bit : ring) {
    bit = static_cast<std::uint8_t>((y + 3) * 8 + x + 3);
    if (x == r && y < r) {
      ++y;
    } else if (y == r && x > -r) {
      --x;
    } else if (x == -r && y > -r) {
      --y;
    } else {
      ++x;
    }
  }
  return ring;
}

}  // namespace detail

/// The points that chains have visited, as far as remembered: a table of tiles
/// of 8 x 8 points, one tile per place, where a newer tile replaces an older
/// one. The other side of a thin line is seen here.
///
/// y is counted in the direction that raises it by Freeman code 2.
class ChainVisits {
 public:
  explicit ChainVisits(int table_bits)
      : tiles_(std::size_t{1} << table_bits), shift_(64 - table_bits) {}

  void mark(Point p) {
    const std::uint64_t key = tile_key(p.x >> 3, p.y >> 3);
    Tile& tile = tiles_[place(key)];
    if (tile.key != key) tile = {0, key};
    tile.points |= std::uint64_t{1} << ((p.y & 7) * 8 + (p.x & 7));
  }

  /// The square rings around a point at distances 1, 2, 3: bit k of ring r is
  /// its k-th point counter-clockwise, from the one straight ahead.
  struct Rings {
    std::uint32_t one, two, three;
  };
  [[nodiscard]] Rings around(Point p, Step ahead) const {
    const std::uint64_t w = window(p.x - 3, p.y - 3);
    return {rotated<8>(gather(w, kRing1), ahead),
            rotated<16>(gather(w, kRing2), 2U * ahead),
            rotated<24>(gather(w, kRing3), 3U * ahead)};
  }

 private:
  struct Tile {
    std::uint64_t points = 0;
    std::uint64_t key = 0;
  };

  static constexpr auto kRing1 = detail::make_ring<1>();
  static constexpr auto kRing2 = detail::make_ring<2>();
  static constexpr auto kRing3 = detail::make_ring<3>();

  template <std::size_t n>
  static std::uint32_t gather(std::uint64_t window,
                              const std::array<std::uint8_t, n>& ring) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < n; ++i) {
      bits |= static_cast<std::uint32_t>(window >> ring[i] & 1) << i;
    }
    return bits;
  }

  template <unsigned n>
  static std::uint32_t rotated(std::uint32_t ring, unsigned by) {
    return (ring >> by | ring << (n - by)) & ((std::uint32_t{1} << n) - 1);
  }

  /// Never 0, so that an unused tile is no tile.
  static std::uint64_t tile_key(std::int32_t x, std::int32_t y) {
    return std::uint64_t{static_cast<std::uint32_t>(x) & 0x0fffffffU} << 32 |
           (static_cast<std::uint32_t>(y) & 0x0fffffffU) |
           std::uint64_t{1} << 63;
  }
  [[nodiscard]] std::size_t place(std::uint64_t key) const {
    return key * 0x9e3779b97f4a7c15ULL >> shift_;
  }
  [[nodiscard]] std::uint64_t points(std::int32_t x, std::int32_t y) const {
    const std::uint64_t key = tile_key(x, y);
    const Tile& tile = tiles_[place(key)];
    return tile.key == key ? tile.points : 0;
  }

  /// The 8 x 8 points from (x, y): byte r is the row y + r, its bit c the
  /// point x + c.
  [[nodiscard]] std::uint64_t window(std::int32_t x, std::int32_t y) const {
    const std::int32_t tx = x >> 3;
    const std::int32_t ty = y >> 3;
    const int right = x & 7;
    const std::uint64_t west = column(tx, ty, y & 7);
    if (right == 0) return west;
    const std::uint64_t east = column(tx + 1, ty, y & 7);
    const std::uint64_t low = 0x0101010101010101ULL * (0xffU >> right);
    return (west >> right & low) | (east << (8 - right) & ~low);
  }
  [[nodiscard]] std::uint64_t column(std::int32_t tx, std::int32_t ty,
                                     int up) const {
    const std::uint64_t lower = points(tx, ty);
    if (up == 0) return lower;
    return lower >> (8 * up) | points(tx, ty + 1) << (64 - 8 * up);
  }

  std::vector<Tile> tiles_;
  int shift_;
};

}  // namespace unstep::codec
