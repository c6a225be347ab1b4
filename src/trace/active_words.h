#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace unstep::trace {

/// Which words of a raster something is to be done with: a bit for each, so
/// 1/64 of the raster.
class ActiveWords {
 public:
  ActiveWords(std::size_t words_per_row, std::size_t rows)
      : per_row_((words_per_row + 63) / 64), bits_(per_row_ * rows) {}

  void set(std::size_t row, std::size_t word) {
    bits_[row * per_row_ + word / 64] |= std::uint64_t{1} << (word % 64);
  }
  void clear() { std::fill(bits_.begin(), bits_.end(), 0); }

  /// The set words of `a` and `b` and all around them. REQUIRES: same size.
  void set_around(const ActiveWords& a, const ActiveWords& b) {
    const std::size_t rows = bits_.size() / per_row_;
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t i = 0; i < per_row_; ++i) {
        const std::uint64_t here = column(a, b, row, i);
        std::uint64_t wide = here | here << 1 | here >> 1;
        if (i > 0) wide |= column(a, b, row, i - 1) >> 63;
        if (i + 1 < per_row_) wide |= column(a, b, row, i + 1) << 63;
        bits_[row * per_row_ + i] = wide;
      }
    }
  }

  /// Calls use(word) for each set word of a row below `count`, ascending.
  template <class Use>
  void for_each(std::size_t row, std::size_t count, Use use) const {
    for (std::size_t i = 0; i < per_row_; ++i) {
      std::uint64_t left = bits_[row * per_row_ + i];
      for (; left != 0; left &= left - 1) {
        const std::size_t word =
            i * 64 + static_cast<std::size_t>(std::countr_zero(left));
        if (word < count) use(word);
      }
    }
  }

 private:
  /// 64 words of the row or of those above and below it.
  static std::uint64_t column(const ActiveWords& a, const ActiveWords& b,
                              std::size_t row, std::size_t i) {
    const std::size_t at = row * a.per_row_ + i;
    std::uint64_t bits = a.bits_[at] | b.bits_[at];
    if (row > 0) bits |= a.bits_[at - a.per_row_] | b.bits_[at - a.per_row_];
    if (at + a.per_row_ < a.bits_.size()) {
      bits |= a.bits_[at + a.per_row_] | b.bits_[at + a.per_row_];
    }
    return bits;
  }

  std::size_t per_row_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace unstep::trace
