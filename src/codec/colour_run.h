#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace unstep::codec {

/// The first pixel from x on that is not of the colour; `end` if none is. The
/// first pixel of a word of the row is the highest.
[[nodiscard]] inline std::int32_t first_other(const std::uint64_t* row,
                                              std::int32_t x, std::int32_t end,
                                              bool ink) {
  const std::uint64_t colour = ink ? ~std::uint64_t{0} : 0;
  while (x < end) {
    const std::uint64_t other = (row[x / 64] ^ colour) << x % 64;
    if (other != 0) return std::min(end, x + std::countl_zero(other));
    x += 64 - x % 64;
  }
  return end;
}

/// Where in x .. end - 1 a run changes its colour, by halves, none likelier.
/// `change`: the truth.
template <class Coder>
std::int32_t code_change(Coder& coder, std::int32_t change, std::int32_t x,
                         std::int32_t end) {
  while (end - x > 1) {
    const std::int32_t middle = x + (end - x) / 2;
    if (coder.code(change >= middle, 32768)) {
      x = middle;
    } else {
      end = middle;
    }
  }
  return x;
}

}  // namespace unstep::codec
