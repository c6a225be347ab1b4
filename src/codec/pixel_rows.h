#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace unstep::codec {

/// The row that is being coded and the last ones above it, with a word of paper
/// on either side. Above the first row all is paper. As in Bitmap the first
/// pixel of a word is the highest.
class PixelRows {
 public:
  static constexpr std::int32_t kRows = 8;  ///< a power of 2

  explicit PixelRows(std::int32_t width)
      : stride_((static_cast<std::size_t>(width) + 63) / 64 + 2),
        words_(stride_ * kRows) {}

  static std::uint64_t memory(std::int32_t width) {
    return ((static_cast<std::uint64_t>(width) + 63) / 64 + 2) * 8 * kRows;
  }

  /// Word i is of the pixels 64 i and on; -1 .. (width + 63) / 64 can be read.
  [[nodiscard]] std::uint64_t* row(std::int32_t y) {
    return words_.data() + static_cast<std::size_t>(y & (kRows - 1)) * stride_ +
           1;
  }

  void clear(std::int32_t y) {
    std::uint64_t* words = row(y) - 1;
    for (std::size_t i = 0; i < stride_; ++i) words[i] = 0;
  }

 private:
  std::size_t stride_;
  std::vector<std::uint64_t> words_;
};

/// The pixels x - 32 .. x + 31 of this row and those above. Pixel x is bit 31.
/// Moving on is a shift, as long as the pixels to the right are enough.
struct PixelWindow {
  static constexpr std::int32_t kRows = 5;
  /// So often it may be moved: the contexts see 11 pixels to the right.
  static constexpr std::int32_t kMoves = 20;

  std::array<std::uint64_t, kRows> row{};

  static std::uint64_t from(const std::uint64_t* words, std::int32_t x) {
    const std::int32_t first = x - 32;
    const std::uint64_t* at = words + (first >> 6);
    const auto shift = static_cast<unsigned>(first) & 63U;
    return at[0] << shift | at[1] >> 1 >> (63 - shift);
  }

  void look(const std::array<std::uint64_t*, kRows>& rows, std::int32_t x) {
    for (std::size_t k = 0; k < row.size(); ++k) row[k] = from(rows[k], x);
  }

  /// Pixel x is known to be `bit`; the next one is in the middle.
  void move(bool bit) {
    row[0] |= std::uint64_t{bit} << 31;
    for (std::uint64_t& pixels : row) pixels <<= 1;
  }

  /// The `count` pixels before x, in this row.
  [[nodiscard]] std::uint64_t before(int count) const {
    return row[0] >> 32 & ((std::uint64_t{1} << count) - 1);
  }
  /// `left` pixels before x, x and `right` after it, in the row y - k.
  [[nodiscard]] std::uint64_t cut(std::size_t k, int left, int right) const {
    return row[k] >> (31 - right) &
           ((std::uint64_t{1} << (left + right + 1)) - 1);
  }
  /// How many pixels before x in the row y - k have the colour of the last of
  /// them, at most 32.
  [[nodiscard]] int alike_before(std::size_t k) const {
    const auto pixels = static_cast<std::uint32_t>(row[k] >> 32);
    return std::countr_zero((pixels & 1) != 0 ? ~pixels : pixels);
  }
  /// The same of x and those after it. REQUIRES: not moved.
  [[nodiscard]] int alike_from(std::size_t k) const {
    const auto pixels = static_cast<std::uint32_t>(row[k]);
    return std::countl_zero(pixels >> 31 != 0 ? ~pixels : pixels);
  }
  /// The nearest 16 pixels.
  [[nodiscard]] std::uint64_t near() const {
    return before(4) | cut(1, 3, 3) << 4 | cut(2, 2, 2) << 11;
  }
};

}  // namespace unstep::codec
