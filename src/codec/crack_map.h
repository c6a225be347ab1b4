#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "trace/contour_turn.h"

namespace unstep::codec {

using trace::kQuarterDx;
using trace::kQuarterDy;
using trace::Quarter;

/// The cracks that are known so far: two bit planes over the grid points of a
/// raster of width x height pixels. A set bit of the horizontal plane at point
/// (x, y) is the crack from there to (x + 1, y), of the vertical plane the one
/// to (x, y + 1).
///
/// Bits are addressed by one number, so that a neighbour is a constant away.
/// Within a word the first bit is the highest, as in Bitmap. kMargin points
/// around the raster can be read and are never set.
class CrackMap {
 public:
  static constexpr std::int32_t kMargin = 16;
  using Address = std::ptrdiff_t;

  /// Bytes that the constructor allocates. No overflow: sides < 2^30, so a
  /// plane has fewer than 2^31 * 2^31 bits.
  static std::uint64_t memory(std::int32_t width, std::int32_t height) {
    return (stride_words(width) * plane_rows(height) * 2 +
            stride_words(height) * plane_rows(width)) *
           8;
  }

  CrackMap(std::int32_t width, std::int32_t height)
      : width_(width),
        height_(height),
        stride_(static_cast<Address>(stride_words(width) * 64)),
        plane_(stride_ * static_cast<Address>(plane_rows(height))),
        flipped_stride_(static_cast<Address>(stride_words(height) * 64)),
        bytes_(memory(width, height)) {}

  [[nodiscard]] std::int32_t width() const { return width_; }
  [[nodiscard]] std::int32_t height() const { return height_; }

  /// The point's bit in the horizontal plane.
  [[nodiscard]] Address at(std::int32_t x, std::int32_t y) const {
    return (Address{y} + kMargin) * stride_ + x + 64;
  }
  [[nodiscard]] Address stride() const { return stride_; }
  /// What to add to reach the same point in the vertical plane.
  [[nodiscard]] Address vertical() const { return plane_; }

  /// The point's bit in the flipped plane, which holds the horizontal cracks
  /// again, column after column, so that those above each other are neighbours.
  [[nodiscard]] Address flipped_at(std::int32_t x, std::int32_t y) const {
    return 2 * plane_ + (Address{x} + kMargin) * flipped_stride_ + y + 64;
  }
  [[nodiscard]] Address flipped_step(Quarter direction) const {
    switch (direction) {
      case 0: return flipped_stride_;
      case 1: return 1;
      case 2: return -flipped_stride_;
      default: return -1;
    }
  }

  /// The address of the crack that leaves a point towards a direction,
  /// relative to the point.
  [[nodiscard]] Address crack(Quarter direction) const {
    switch (direction) {
      case 0: return 0;
      case 1: return plane_;
      case 2: return -1;
      default: return plane_ - stride_;
    }
  }
  /// The point one step away, relative to the point.
  [[nodiscard]] Address step(Quarter direction) const {
    switch (direction) {
      case 0: return 1;
      case 1: return stride_;
      case 2: return -1;
      default: return -stride_;
    }
  }

  [[nodiscard]] unsigned test(Address bit) const {
    const auto u = static_cast<std::size_t>(bit);
    return static_cast<unsigned>(bytes_[u / 8]) >> (7 - u % 8) & 1U;
  }
  /// Marks the crack from a point (and its address in the flipped plane).
  void mark(Address point, Address flipped, Quarter direction) {
    set(point + crack(direction));
    if (direction == 0) set(flipped);
    if (direction == 2) set(flipped - flipped_stride_);
  }

  /// The aligned word that starts at point (64 * word, y) of the horizontal
  /// plane; -1 and one past the last used word are margins.
  [[nodiscard]] std::uint64_t horizontal_word(std::int32_t y,
                                              std::int32_t word) const {
    return load(static_cast<std::size_t>(at(0, y) / 8 + Address{word} * 8));
  }
  [[nodiscard]] std::uint64_t vertical_word(std::int32_t y,
                                            std::int32_t word) const {
    return load(
        static_cast<std::size_t>((at(0, y) + plane_) / 8 + Address{word} * 8));
  }

  /// For each of the words from `word` on: the cracks at its points in rows y
  /// - 1 to y + 1, upright ones from y - 2 on, in one word that ordered() puts
  /// in order. As many as `out` has, which must end at the right margin or
  /// before.
  void known_around(std::int32_t y, std::int32_t word,
                    std::span<std::uint64_t> out) const {
    const Address from = at(0, y) / 8 + Address{word} * 8;
    const Address row = stride_ / 8;
    const auto plane = [&](Address offset) {
      return bytes_.data() + static_cast<std::size_t>(from + offset);
    };
    const std::array<const std::uint8_t*, 7> rows{plane(-row),
                                                  plane(0),
                                                  plane(row),
                                                  plane(plane_ / 8 - 2 * row),
                                                  plane(plane_ / 8 - row),
                                                  plane(plane_ / 8),
                                                  plane(plane_ / 8 + row)};
    for (std::size_t i = 0; i < out.size(); ++i) {
      std::uint64_t any = 0;
      for (const std::uint8_t* bytes : rows) {
        std::uint64_t cracks = 0;
        std::memcpy(&cracks, bytes + 8 * i, 8);
        any |= cracks;
      }
      out[i] = any;
    }
  }
  /// A word as it lies in memory: the first point in the highest bit.
  [[nodiscard]] static std::uint64_t ordered(std::uint64_t word) {
    if constexpr (std::endian::native == std::endian::little) {
      word = __builtin_bswap64(word);
    }
    return word;
  }

  /// At least kWindow bits from `bit` on, the first in the highest place; below
  /// them is nothing to rely on.
  static constexpr int kWindow = 57;
  [[nodiscard]] std::uint64_t window(Address bit) const {
    const auto u = static_cast<std::size_t>(bit);
    return load(u / 8) << (u % 8);
  }

 private:
  void set(Address bit) {
    const auto u = static_cast<std::size_t>(bit);
    bytes_[u / 8] = static_cast<std::uint8_t>(bytes_[u / 8] | 0x80U >> u % 8);
  }
  /// 8 bytes, the first one highest.
  [[nodiscard]] std::uint64_t load(std::size_t byte) const {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes_.data() + byte, 8);
    return ordered(word);
  }
  // A word of margin on the left; on the right the points up to x = width and
  // at least one more word, so that window() stays inside the planes.
  static std::uint64_t stride_words(std::int32_t width) {
    return (static_cast<std::uint64_t>(width) + 1 + 63) / 64 + 2;
  }
  static std::uint64_t plane_rows(std::int32_t height) {
    return static_cast<std::uint64_t>(height) + 1 + 2 * kMargin;
  }

  std::int32_t width_;
  std::int32_t height_;
  Address stride_;
  Address plane_;
  Address flipped_stride_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace unstep::codec
