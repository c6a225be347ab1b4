#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "entropy/logistic.h"

namespace unstep::entropy {

namespace detail {

/// 65536 / (n + 1.6): how far observation n + 1 moves a probability.
constexpr std::array<std::uint16_t, 256> make_rates() {
  std::array<std::uint16_t, 256> rates{};
  for (unsigned n = 0; n < 256; ++n) {
    rates[n] = static_cast<std::uint16_t>(655360U / (10 * n + 16));
  }
  return rates;
}

inline constexpr auto kRates = make_rates();

}  // namespace detail

/// Moves a probability towards an observed bit by rate / 65536 of the way and
/// one more, so that certainty is reached in the end. The same for both bits.
[[nodiscard]] constexpr std::uint16_t moved(std::uint16_t p, bool bit,
                                            std::uint16_t rate) {
  const std::uint16_t flip = bit ? 0xffff : 0;
  auto miss = static_cast<std::uint16_t>(p ^ flip);
  miss =
      static_cast<std::uint16_t>(miss - ((std::uint32_t{miss} * rate) >> 16));
  miss = static_cast<std::uint16_t>(miss - (miss != 0 ? 1 : 0));
  return static_cast<std::uint16_t>(miss ^ flip);
}

/// An adaptive probability with its own age: the first observations move it
/// fast, later ones as 1 / (n + 1.6), down to 1 / (kLimit + 1.6).
struct Counter {
  static constexpr int kLimit = 255;

  std::uint16_t p = 32768;  ///< of 65536 that the next bit is 1
  std::uint8_t n = 0;       ///< observations, saturating at kLimit

  void update(bool bit) {
    p = moved(p, bit, detail::kRates[n]);
    if (n < kLimit) ++n;
  }

  /// The probability, kept off the ends so that it can be coded with.
  [[nodiscard]] int p1() const { return std::clamp<int>(p, 16, 65520); }
  /// The same for events so rare that 1 / 4096 would be dear.
  [[nodiscard]] int p1_fine() const { return std::clamp<int>(p, 2, 65534); }
};

}  // namespace unstep::entropy
