#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "unstep/result.h"

namespace unstep {

/// A bilevel raster, packed. Pixel (x, y), y down, is bit 63 - x % 64 of word
/// x / 64 of row y; 1 is ink. Each row starts at a word; the unused low bits of
/// the last word of a row are always 0 (INVARIANT, every writer keeps it).
///
///     Result<Bitmap> page = Bitmap::create(2480, 3508);
///     page->set(10, 20, true);
class Bitmap {
 public:
  /// Both sides are 1..kMaxSide; memory is 8 * ceil(width / 64) * height bytes.
  static constexpr std::int32_t kMaxSide = (1 << 30) - 1;

  Bitmap() = default;  ///< 0 x 0

  /// An all-paper raster. out_of_range if a side is not in 1..kMaxSide,
  /// limit_exceeded if memory cannot be had. Callers check their own limits
  /// before they call.
  static Result<Bitmap> create(std::int64_t width, std::int64_t height);

  [[nodiscard]] std::int32_t width() const { return width_; }
  [[nodiscard]] std::int32_t height() const { return height_; }
  [[nodiscard]] std::size_t words_per_row() const { return words_per_row_; }
  [[nodiscard]] std::uint64_t pixels() const {
    return static_cast<std::uint64_t>(width_) *
           static_cast<std::uint64_t>(height_);
  }

  /// REQUIRES: 0 <= y < height().
  [[nodiscard]] std::span<std::uint64_t> row(std::int32_t y) {
    return {words_.data() + offset(y), words_per_row_};
  }
  [[nodiscard]] std::span<const std::uint64_t> row(std::int32_t y) const {
    return {words_.data() + offset(y), words_per_row_};
  }

  /// REQUIRES: inside the raster.
  [[nodiscard]] bool get(std::int32_t x, std::int32_t y) const {
    const auto ux = static_cast<std::uint32_t>(x);
    return (words_[offset(y) + ux / 64] >> (63 - ux % 64) & 1) != 0;
  }
  void set(std::int32_t x, std::int32_t y, bool ink) {
    const auto ux = static_cast<std::uint32_t>(x);
    const std::uint64_t bit = std::uint64_t{1} << (63 - ux % 64);
    std::uint64_t& word = words_[offset(y) + ux / 64];
    word = ink ? word | bit : word & ~bit;
  }

  /// The mask of the used bits of the last word of a row.
  [[nodiscard]] std::uint64_t last_word_mask() const {
    const auto used = static_cast<unsigned>(width_) % 64;
    return used == 0 ? ~std::uint64_t{0} : ~std::uint64_t{0} << (64 - used);
  }

  /// Row from/to bytes as PBM, PNG and TIFF hold them: 8 pixels a byte, first
  /// pixel in the high bit, ceil(width / 8) bytes. `invert`: 0 in the bytes is
  /// ink. REQUIRES: bytes.size() == (width() + 7) / 8.
  void set_row_bytes(std::int32_t y, std::span<const std::uint8_t> bytes,
                     bool invert);
  void get_row_bytes(std::int32_t y, std::span<std::uint8_t> bytes,
                     bool invert) const;

  /// CRC-32 (zlib) over the rows as get_row_bytes(invert = false) gives them,
  /// first row first. The identity of the pixels, independent of packing.
  [[nodiscard]] std::uint32_t crc32() const;

  /// The number of ink pixels.
  [[nodiscard]] std::uint64_t ink() const;

  friend bool operator==(const Bitmap&, const Bitmap&) = default;

 private:
  [[nodiscard]] std::size_t offset(std::int32_t y) const {
    return static_cast<std::size_t>(y) * words_per_row_;
  }

  std::int32_t width_ = 0;
  std::int32_t height_ = 0;
  std::size_t words_per_row_ = 0;
  std::vector<std::uint64_t> words_;
};

}  // namespace unstep
