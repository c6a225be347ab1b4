#pragma once

#include <cstdint>
#include <span>

namespace unstep::render {

/// Every pixel becomes the parity of itself and the pixels on its left.
inline void fill_row(std::span<std::uint64_t> row,
                     std::uint64_t last_word_mask) {
  std::uint64_t carry = 0;
  for (std::uint64_t& word : row) {
    for (const unsigned shift : {1U, 2U, 4U, 8U, 16U, 32U}) {
      word ^= word >> shift;
    }
    word ^= carry;
    carry = (word & 1) != 0 ? ~std::uint64_t{0} : 0;
  }
  row.back() &= last_word_mask;
}

}  // namespace unstep::render
