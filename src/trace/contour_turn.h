#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace unstep::trace {

/// A quarter direction in a raster (y down), clockwise as seen: 0 east,
/// 1 south, 2 west, 3 north.
using Quarter = int;

inline constexpr std::array<std::int32_t, 4> kQuarterDx{1, 0, -1, 0};
inline constexpr std::array<std::int32_t, 4> kQuarterDy{0, 1, 0, -1};

/// What a contour does at a grid point, relative to the way it came.
enum Turn : std::uint8_t { kStraight = 0, kLeft = 1, kRight = 2 };

[[nodiscard]] constexpr Quarter turned(Quarter direction, Turn turn) {
  return (direction + (turn == kLeft ? 3 : turn == kRight ? 1 : 0)) & 3;
}

/// The turn of a contour that reached grid point (x, y) along `direction` with
/// the colour `ink` on its right hand. `pixel(x, y)` tells whether a pixel is
/// ink; it is asked for pixels beside the raster too. The saddle rule of
/// trace.h is here: ink is 8-connected, paper 4-connected.
template <class Pixel>
[[nodiscard]] Turn true_turn(const Pixel& pixel, std::int32_t x, std::int32_t y,
                             Quarter direction, bool ink) {
  // The pixels ahead on the left and on the right hand.
  constexpr std::array<std::int32_t, 4> kRightX{0, -1, -1, 0};
  constexpr std::array<std::int32_t, 4> kRightY{0, 0, -1, -1};
  constexpr std::array<std::int32_t, 4> kLeftX{0, 0, -1, -1};
  constexpr std::array<std::int32_t, 4> kLeftY{-1, 0, 0, -1};
  const auto d = static_cast<std::size_t>(direction);
  const bool right = pixel(x + kRightX[d], y + kRightY[d]) == ink;
  const bool left = pixel(x + kLeftX[d], y + kLeftY[d]) == ink;
  if (right) return left ? kLeft : kStraight;
  if (!left) return kRight;
  return ink ? kLeft : kRight;
}

}  // namespace unstep::trace
