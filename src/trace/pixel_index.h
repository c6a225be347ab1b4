#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "unstep/bitmap.h"
#include "unstep/grid.h"

namespace unstep::trace {

/// Numbers the ink pixels of a raster in raster order, so that what is known
/// of them needs an array of their number only. Half the memory of the raster.
class PixelIndex {
 public:
  /// REQUIRES: fewer than 2^32 ink pixels; `ink` outlives this, unchanged.
  explicit PixelIndex(const Bitmap& ink) : ink_(ink) {
    before_.reserve(ink.words_per_row() *
                    static_cast<std::size_t>(ink.height()));
    for (std::int32_t y = 0; y < ink.height(); ++y) {
      for (const std::uint64_t word : ink.row(y)) {
        before_.push_back(static_cast<std::uint32_t>(size_));
        size_ += static_cast<std::size_t>(std::popcount(word));
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return size_; }

  /// REQUIRES: an ink pixel.
  [[nodiscard]] std::size_t of(Point at) const {
    const auto x = static_cast<std::uint32_t>(at.x);
    const std::uint64_t word = ink_.row(at.y)[x / 64];
    const std::uint64_t left = x % 64 == 0 ? 0 : word >> (64 - x % 64);
    return before_[static_cast<std::size_t>(at.y) * ink_.words_per_row() +
                   x / 64] +
           static_cast<std::size_t>(std::popcount(left));
  }

 private:
  const Bitmap& ink_;
  std::vector<std::uint32_t> before_;  ///< ink pixels before each word
  std::size_t size_ = 0;
};

}  // namespace unstep::trace
