#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "interpolate/ticks.h"
#include "unstep/interpolate.h"

/// B: the binary rate multiplier of "Interpolator", section 3.2.2.
namespace unstep::interpolation {

/// A frame of 2^n master pulses. Pulse k < 2^n fires the one-shot of divider
/// stage ctz(k); an axis moves if the register bit n - 1 - ctz(k) is 1, so a
/// register d gets exactly d pulses. Pulse 2^n fires no stage: it resets the
/// end-of-frame trigger, and the generator stops.
///
/// Per axis, stage j fires floor((k + 2^j) / 2^(j + 1)) times up to pulse k,
/// off its share k / 2^(j + 1) by 1/2 at most: an axis is never further than
/// n / 2 from d k / 2^n.
class RateMultiplier {
 public:
  /// REQUIRES: |dx|, |dy| < 2^bits, 0 <= bits <= kMaxRateBits. No bits, no
  /// pulses.
  RateMultiplier(Segment segment, int bits);

  /// The smallest n that holds both deltas; 0 for no move.
  static int bits_for(Segment segment);

  Tick next();
  std::size_t registers(std::span<Register, kMaxRegisters> out) const;

 private:
  Quadrant quadrant_;
  int bits_;
  std::uint64_t pulse_ = 0;
  bool trigger_;
};

}  // namespace unstep::interpolation
