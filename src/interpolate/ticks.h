#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "unstep/grid.h"
#include "unstep/interpolate.h"

/// What the line methods share: magnitudes and the quadrant's steps.
namespace unstep::interpolation {

__extension__ typedef __int128 Int128;

/// Fractions of steps and frequencies are kept in units of 2^-32.
inline constexpr double kTwo32 = 4294967296.0;

/// |value|, 2^31 for INT32_MIN.
[[nodiscard]] constexpr std::int64_t magnitude(std::int32_t value) {
  const std::int64_t wide = value;
  return wide < 0 ? -wide : wide;
}

/// A segment as first-quadrant magnitudes and the signs that lead back: the
/// symmetry every line method uses.
struct Quadrant {
  std::int64_t xk = 0;
  std::int64_t yk = 0;
  Step along_x = 0;
  Step along_y = 2;

  constexpr explicit Quadrant(Segment s)
      : xk(magnitude(s.dx)),
        yk(magnitude(s.dy)),
        along_x(s.dx < 0 ? 4 : 0),
        along_y(s.dy < 0 ? 6 : 2) {}

  /// The diagonal code lies between the two, 7 between 6 and 0.
  [[nodiscard]] constexpr Step diagonal() const {
    constexpr std::array<Step, 4> kCode{1, 3, 7, 5};
    return kCode[static_cast<std::size_t>(along_x >> 2 | along_y >> 2 << 1)];
  }
};

[[nodiscard]] constexpr Tick step_tick(Step step) {
  const Point move = step_delta(step);
  return {Tick::Kind::step, step, move.x, move.y};
}

[[nodiscard]] constexpr Tick idle_tick() { return {Tick::Kind::idle, 0, 0, 0}; }

/// The Freeman code of a move of -1..1 on each axis, not both 0.
[[nodiscard]] constexpr Step unit_step(int dx, int dy) {
  // By (dy + 1) * 3 + dx + 1; the centre is no step.
  constexpr std::array<Step, 9> kCode{5, 6, 7, 4, 0, 0, 3, 2, 1};
  return kCode[static_cast<std::size_t>((dy + 1) * 3 + dx + 1)];
}

/// The tick of a move of -1..1 on each axis.
[[nodiscard]] constexpr Tick unit_tick(int dx, int dy) {
  if (dx == 0 && dy == 0) return idle_tick();
  return step_tick(unit_step(dx, dy));
}

}  // namespace unstep::interpolation
