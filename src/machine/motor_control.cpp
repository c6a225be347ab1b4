#include "machine/motor_control.h"

#include <algorithm>
#include <cmath>

namespace unstep::machine {

std::uint64_t rate_pulses(std::uint32_t rate, std::uint32_t bits,
                          std::uint64_t clocks) {
  std::uint64_t pulses = (clocks >> bits) * rate;
  const std::uint64_t rest = clocks & ((std::uint64_t{1} << bits) - 1);
  // Stage j fires at odd multiples of 2^j; its register bit is n - 1 - j.
  for (std::uint32_t j = 0; j < bits; ++j)
    if ((rate >> (bits - 1 - j) & 1) != 0)
      pulses += (rest + (std::uint64_t{1} << j)) >> (j + 1);
  return pulses;
}

MotorControl::MotorControl(Resolution resolution)
    : pulse_um_(pulse_um(resolution)) {}

void MotorControl::start() {
  active_ = mode_;
  running_ = true;
  const bool positioning = active_ == Mode::positioning;
  y_ = positioning ? cr1_ : 0;
  rate_ = positioning ? 0 : cr2_;
  clocks_ = 0;
}

double MotorControl::tick(std::int64_t pulses) {
  speed_ += (static_cast<double>(pulses) - speed_) / 8;
  if (!running_) return 0;
  y_ -= pulses;
  if (rate_ != 0) {
    const auto rate = static_cast<std::uint32_t>(std::abs(rate_));
    const std::uint64_t frame = std::uint64_t{1} << kRateBits;
    const std::uint64_t before = rate_pulses(rate, kRateBits, clocks_);
    const std::uint64_t after =
        rate_pulses(rate, kRateBits, clocks_ + kClocksPerTick);
    clocks_ = (clocks_ + kClocksPerTick) % frame;
    const auto commanded = static_cast<std::int64_t>(after - before);
    y_ += rate_ < 0 ? -commanded : commanded;
  }
  const double y = static_cast<double>(y_) - kLeadTicks * speed_;
  const double duty = std::clamp(y * pulse_um_ / kRangeUm, -1.0, 1.0);
  return std::floor(duty * 1024 + 0.5) / 1024;
}

bool MotorControl::done() const {
  return running_ && active_ == Mode::positioning &&
         std::abs(y_) <= kDoneError &&
         std::abs(speed_) * pulse_um_ < kDoneSpeedUm * kTickSeconds;
}

}  // namespace unstep::machine
