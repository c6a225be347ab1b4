#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "entropy/logistic.h"

namespace unstep::entropy {

namespace detail {

/// 65536 / (n + 1.6), at most 32767 so that a product fits int32:
/// |target - p| <= 65535 and 65535 * 32767 < 2^31.
constexpr std::array<std::uint16_t, 256> make_rates() {
  std::array<std::uint16_t, 256> rates{};
  for (unsigned n = 0; n < 256; ++n) {
    rates[n] = static_cast<std::uint16_t>(
        std::min(655360U / (10 * n + 16), 32767U));
  }
  return rates;
}

inline constexpr auto kRates = make_rates();

}  // namespace detail

/// An adaptive probability with its own age: the first observations move it
/// fast, later ones as 1 / (n + 1.6), down to 1 / (kLimit + 1.6).
struct Counter {
  static constexpr int kLimit = 255;

  std::uint16_t p = 32768;  ///< of 65536 that the next bit is 1
  std::uint8_t n = 0;       ///< observations, saturating at kLimit

  void update(bool bit) { update(bit, kLimit); }

  void update(bool bit, int limit) {
    const int target = bit ? 65535 : 0;
    const int delta = (target - p) * detail::kRates[n];
    p = static_cast<std::uint16_t>(p + (delta >> 16));
    if (n < limit) ++n;
  }

  /// The probability, kept off the ends so that it can be coded with.
  [[nodiscard]] int p1() const { return std::clamp<int>(p, 16, 65520); }
  /// The same for events so rare that 1 / 4096 would be dear.
  [[nodiscard]] int p1_fine() const { return std::clamp<int>(p, 2, 65534); }
};

}  // namespace unstep::entropy
