#pragma once

#include <array>
#include <cstdint>

/// The logistic domain of the mixing coder, in integers only, so that every
/// compiler and machine computes the same bits.
///
/// A probability is a 16-bit number (1..65535 of 65536) that the bit is 1. Its
/// stretch is ln(p / (1 - p)) in steps of 1/256, squash is the inverse.
namespace unstep::entropy {

inline constexpr int kStretchMax = 3071;  ///< about ln-odds of 12

namespace detail {

/// Entry k is squash(k) for k = 0..kStretchMax: 65536 / (1 + exp(-k / 256)),
/// by repeated multiplication with exp(-1 / 256) in 2^-31 fixed point.
constexpr std::array<std::uint16_t, kStretchMax + 1> make_squash() {
  constexpr std::uint64_t kOne = std::uint64_t{1} << 31;
  constexpr std::uint64_t kDecay = 2139111403;  // 2^31 exp(-1 / 256)
  std::array<std::uint16_t, kStretchMax + 1> table{};
  std::uint64_t e = kOne;
  for (auto& entry : table) {
    const std::uint64_t p =
        ((kOne << 17) / (kOne + e) + 1) / 2;  // rounded 65536 / (1 + e)
    entry = static_cast<std::uint16_t>(p > 65535 ? 65535 : p);
    e = (e * kDecay + kOne / 2) >> 31;
  }
  return table;
}

inline constexpr auto kSquash = make_squash();

/// Entry i is the stretch of the middle of [16 i, 16 i + 16) / 65536: the
/// smallest x whose squash reaches it.
constexpr std::array<std::int16_t, 4096> make_stretch() {
  std::array<std::int16_t, 4096> table{};
  int x = 0;
  for (int i = 2048; i < 4096; ++i) {
    while (x < kStretchMax &&
           kSquash[static_cast<std::size_t>(x)] < i * 16 + 8) {
      ++x;
    }
    table[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(x);
    table[static_cast<std::size_t>(4095 - i)] = static_cast<std::int16_t>(-x);
  }
  return table;
}

inline constexpr auto kStretch = make_stretch();

}  // namespace detail

/// The 16-bit probability of a stretch; anything beyond +-kStretchMax is
/// clamped. The result is 1..65535.
[[nodiscard]] constexpr int squash(int x) {
  if (x < 0) {
    if (x < -kStretchMax) x = -kStretchMax;
    return 65536 - detail::kSquash[static_cast<std::size_t>(-x)];
  }
  if (x > kStretchMax) x = kStretchMax;
  return detail::kSquash[static_cast<std::size_t>(x)];
}

/// The stretch of a 16-bit probability. REQUIRES: 0 <= p <= 65535.
[[nodiscard]] inline int stretch(int p) {
  return detail::kStretch[static_cast<std::size_t>(p) >> 4];
}

}  // namespace unstep::entropy
