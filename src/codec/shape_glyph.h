#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace unstep::codec {

/// The longest side of a shape of coder 2.
inline constexpr std::int32_t kMaxShapeSide = 255;

/// A small bitmap: rows of whole words, the first pixel in the highest bit;
/// unused bits are 0.
struct Glyph {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<std::uint64_t> words;

  Glyph() = default;
  Glyph(std::int32_t w, std::int32_t h)
      : width(w), height(h), words(stride() * static_cast<std::size_t>(h)) {}

  [[nodiscard]] std::size_t stride() const {
    return (static_cast<std::size_t>(width) + 63) / 64;
  }
  [[nodiscard]] bool get(std::int32_t x, std::int32_t y) const {
    return (row(y)[x / 64] >> (63 - x % 64) & 1) != 0;
  }
  [[nodiscard]] const std::uint64_t* row(std::int32_t y) const {
    return words.data() + static_cast<std::size_t>(y) * stride();
  }
  [[nodiscard]] std::uint64_t* row(std::int32_t y) {
    return words.data() + static_cast<std::size_t>(y) * stride();
  }
  friend bool operator==(const Glyph&, const Glyph&) = default;
};

/// A glyph's place on a plane that can be read beyond it: kMargin rows above
/// and below and a word on either side.
class ShapeCanvas {
 public:
  static constexpr std::int32_t kMargin = 8;

  ShapeCanvas() : words_(kStride * (kMaxShapeSide + 2 * kMargin)) {}

  /// All paper, for a shape of `height` rows.
  void clear(std::int32_t height) {
    std::fill_n(words_.begin(),
                kStride * static_cast<std::size_t>(height + 2 * kMargin), 0);
    height_ = height;
  }

  /// Draws pixel (x, y) of `glyph` at (x - dx, y - dy), as far as there is
  /// room. REQUIRES: |dx| <= 32.
  void draw(const Glyph& glyph, std::int32_t dx, std::int32_t dy) {
    const std::int32_t first = std::max(0, dy - kMargin);
    const std::int32_t last = std::min(glyph.height, height_ + kMargin + dy);
    const auto start = static_cast<std::size_t>(64 - dx);
    const std::size_t shift = start % 64;
    for (std::int32_t y = first; y < last; ++y) {
      std::uint64_t* to = line(y - dy) + start / 64;
      const std::uint64_t* from = glyph.row(y);
      for (std::size_t i = 0; i < glyph.stride(); ++i) {
        to[i] |= from[i] >> shift;
        to[i + 1] |= shift == 0 ? 0 : from[i] << (64 - shift);
      }
    }
  }

  /// Copies the shape out.
  void take(Glyph& glyph) const {
    for (std::int32_t y = 0; y < glyph.height; ++y) {
      const std::uint64_t* from = row(y) + 1;
      std::copy(from, from + glyph.stride(), glyph.row(y));
    }
  }

  using Row = const std::uint64_t*;

  /// REQUIRES: -kMargin <= y < height + kMargin.
  [[nodiscard]] Row row(std::int32_t y) const {
    return words_.data() + static_cast<std::size_t>(y + kMargin) * kStride;
  }
  /// The pixels x - 32 .. x + 31 of a row, the first in the highest bit.
  [[nodiscard]] static std::uint64_t window(Row row, std::int32_t x) {
    const auto bit = static_cast<unsigned>(x + 32);
    const Row at = row + bit / 64;
    return at[0] << bit % 64 | at[1] >> 1 >> (63 - bit % 64);
  }
  void set(std::int32_t x, std::int32_t y) {
    const auto bit = static_cast<std::size_t>(x + 64);
    line(y)[bit / 64] |= std::uint64_t{1} << (63 - bit % 64);
  }
  /// Inks the pixels first .. end - 1 of a row.
  void fill(std::int32_t first, std::int32_t end, std::int32_t y) {
    for (std::int32_t x = first; x < end; ++x) set(x, y);
  }

 private:
  static constexpr std::size_t kStride = 7;

  [[nodiscard]] std::uint64_t* line(std::int32_t y) {
    return words_.data() + static_cast<std::size_t>(y + kMargin) * kStride;
  }
  std::vector<std::uint64_t> words_;
  std::int32_t height_ = 0;
};

}  // namespace unstep::codec
