#include "interpolate/rate_multiplier.h"

#include <algorithm>
#include <bit>

namespace unstep::interpolation {

RateMultiplier::RateMultiplier(Segment segment, int bits)
    : quadrant_(segment), bits_(bits), trigger_(bits > 0) {}

int RateMultiplier::bits_for(Segment segment) {
  const std::int64_t larger =
      std::max(magnitude(segment.dx), magnitude(segment.dy));
  return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(larger)));
}

Tick RateMultiplier::next() {
  if (!trigger_) return {};
  ++pulse_;
  if (pulse_ == std::uint64_t{1} << bits_) {
    trigger_ = false;
    return idle_tick();
  }
  const int bit = bits_ - 1 - std::countr_zero(pulse_);
  const bool x = (quadrant_.xk >> bit & 1) != 0;
  const bool y = (quadrant_.yk >> bit & 1) != 0;
  if (x && y) return step_tick(quadrant_.diagonal());
  if (x) return step_tick(quadrant_.along_x);
  if (y) return step_tick(quadrant_.along_y);
  return idle_tick();
}

std::size_t RateMultiplier::registers(
    std::span<Register, kMaxRegisters> out) const {
  out[0] = {"RGx", quadrant_.xk};
  out[1] = {"RGy", quadrant_.yk};
  out[2] = {"pulse", static_cast<std::int64_t>(pulse_)};
  out[3] = {"trigger", trigger_};
  return 4;
}

}  // namespace unstep::interpolation
