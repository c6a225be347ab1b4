#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace unstep::codec {

/// What the rows above say of each pixel of a row, found a word at a time.
class PixelMasks {
 public:
  explicit PixelMasks(std::int32_t width)
      : words_((static_cast<std::size_t>(width) + 63) / 64),
        beyond_(width % 64 == 0 ? 0 : ~std::uint64_t{0} >> width % 64),
        edges_(words_ + 1, ~std::uint64_t{0}) {}

  static std::uint64_t memory(std::int32_t width) {
    return 8 * ((static_cast<std::uint64_t>(width) + 63) / 64 + 1);
  }

  /// `a`, `b`: the rows above, the nearest first, with a word on either side.
  void find(const std::uint64_t* a, const std::uint64_t* b) {
    for (std::size_t i = 0; i < words_; ++i, ++a, ++b) {
      const std::uint64_t any = a[-1] | a[0] | a[1] | b[-1] | b[0] | b[1];
      edges_[i] = any == 0 ? 0 : spread_edges(a, 3) | spread_edges(b, 2);
    }
    edges_[words_ - 1] |= beyond_;
  }

  /// The 64 pixels from x on, the first in the highest place: whether pixels of
  /// both colours are within 3 pixels in the row above, or within 2 in the one
  /// above that. Beyond the row all are set.
  [[nodiscard]] std::uint64_t edges(std::int32_t x) const {
    return from(edges_, x);
  }
  /// The first pixel from x on that has such a bit.
  [[nodiscard]] std::int32_t next_edge(std::int32_t x) const {
    return next(edges_, x);
  }

 private:
  using Mask = std::vector<std::uint64_t>;

  /// The pixels that see both colours within `reach` pixels of a row.
  static std::uint64_t spread_edges(const std::uint64_t* row, int reach) {
    // An edge is between a pixel and the one before.
    const std::uint64_t left = row[-1] ^ row[-1] >> 1;
    const std::uint64_t here = row[0] ^ (row[0] >> 1 | row[-1] << 63);
    const std::uint64_t right = row[1] ^ (row[1] >> 1 | row[0] << 63);
    std::uint64_t all = here;
    for (int d = 1; d <= reach; ++d) {
      all |= here << d | right >> (64 - d);
      if (d < reach) all |= here >> d | left << (64 - d);
    }
    return all;
  }
  static std::uint64_t from(const Mask& mask, std::int32_t x) {
    const auto word = static_cast<std::size_t>(x) / 64;
    const unsigned shift = static_cast<unsigned>(x) % 64;
    const std::uint64_t after = word + 1 < mask.size() ? mask[word + 1] : ~0ULL;
    return mask[word] << shift | after >> 1 >> (63 - shift);
  }
  static std::int32_t next(const Mask& mask, std::int32_t x) {
    auto word = static_cast<std::size_t>(x) / 64;
    const unsigned shift = static_cast<unsigned>(x) % 64;
    std::uint64_t set = mask[word] << shift;
    if (set != 0) return x + std::countl_zero(set);
    while (mask[++word] == 0) {
    }
    return static_cast<std::int32_t>(word * 64) + std::countl_zero(mask[word]);
  }

  std::size_t words_;
  std::uint64_t beyond_;  ///< the bits of the last word that are no pixels
  Mask edges_;            ///< one more word, all set
};

}  // namespace unstep::codec
