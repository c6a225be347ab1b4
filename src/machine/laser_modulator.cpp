#include "machine/laser_modulator.h"

#include <algorithm>
#include <cstdlib>

namespace unstep::machine {

void LaserModulator::load_dr1(std::uint32_t value) {
  dr1_ = value & ((1U << kLevelBits) - 1);
}

std::int64_t LaserModulator::move(std::int64_t pulses, std::int64_t now_ns) {
  const std::int64_t distance = dr2_;
  const std::int64_t before = way_;
  way_ += pulses;
  if (distance == 0 || std::abs(way_) < distance) return 0;
  const std::int64_t compared = way_ < 0 ? -distance : distance;
  way_ -= compared;
  if (mode_ != Mode::pulse || !on_) return 0;
  if (now_ns - last_ns_ < kMinPeriodNs) {
    ++refused_;
    return 0;
  }
  last_ns_ = now_ns;
  ++flashes_;
  return compared - before;
}

std::int32_t LaserModulator::width_us() const {
  return std::min(static_cast<std::int32_t>(dr1_), kMaxWidthUs);
}

std::int32_t LaserModulator::level_mv() const {
  return on_ && mode_ == Mode::level ? static_cast<std::int32_t>(dr1_) : 0;
}

}  // namespace unstep::machine
