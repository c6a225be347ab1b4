#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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
    return stride_words(width) * plane_rows(height) * 2 * 8;
  }

  CrackMap(std::int32_t width, std::int32_t height)
      : width_(width),
        height_(height),
        stride_(static_cast<Address>(stride_words(width) * 64)),
        plane_(stride_ * static_cast<Address>(plane_rows(height))),
        words_(stride_words(width) * plane_rows(height) * 2) {}

  [[nodiscard]] std::int32_t width() const { return width_; }
  [[nodiscard]] std::int32_t height() const { return height_; }

  /// The point's bit in the horizontal plane.
  [[nodiscard]] Address at(std::int32_t x, std::int32_t y) const {
    return (Address{y} + kMargin) * stride_ + x + 64;
  }
  [[nodiscard]] Address stride() const { return stride_; }
  /// What to add to reach the same point in the vertical plane.
  [[nodiscard]] Address vertical() const { return plane_; }

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
    return static_cast<unsigned>(words_[u / 64] >> (63 - u % 64)) & 1U;
  }
  void set(Address bit) {
    const auto u = static_cast<std::size_t>(bit);
    words_[u / 64] |= std::uint64_t{1} << (63 - u % 64);
  }

  /// The aligned word that starts at point (64 * word, y) of the horizontal
  /// plane; -1 and one past the last used word are margins.
  [[nodiscard]] std::uint64_t horizontal_word(std::int32_t y,
                                              std::int32_t word) const {
    return words_[static_cast<std::size_t>((at(0, y) >> 6) + word)];
  }
  [[nodiscard]] std::uint64_t vertical_word(std::int32_t y,
                                            std::int32_t word) const {
    return words_[static_cast<std::size_t>(((at(0, y) + plane_) >> 6) + word)];
  }

  /// 64 bits from `bit` on, the first in the highest place.
  [[nodiscard]] std::uint64_t window(Address bit) const {
    const auto u = static_cast<std::size_t>(bit);
    const std::uint64_t high = words_[u / 64];
    const std::uint64_t low = words_[u / 64 + 1];
    return high << (u % 64) | (low >> 1) >> (63 - u % 64);
  }

 private:
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
  std::vector<std::uint64_t> words_;
};

}  // namespace unstep::codec
