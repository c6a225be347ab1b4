#include "machine/pulse_former.h"

#include <cmath>
#include <numbers>

namespace unstep::machine {

PulseFormer::PulseFormer(Resolution resolution, double hysteresis)
    : resolution_(resolution), sine_(hysteresis), cosine_(hysteresis) {}

int PulseFormer::update(double sine, double cosine) {
  const bool s = sine_.update(sine);
  const bool c = cosine_.update(cosine);
  const int before = quadrant_;
  quadrant_ = s ? (c ? 0 : 1) : (c ? 3 : 2);
  if (before < 0) return 0;
  const int turned = (quadrant_ - before) & 3;
  if (turned == 2) ++lost_;
  if (turned != 1 && turned != 3) return 0;
  const int pulse = turned == 1 ? 1 : -1;
  if (resolution_ == Resolution::eighth_wave) return pulse;
  // The edge of the sine while the cosine is high, either way.
  const bool counted = (pulse > 0 ? quadrant_ : before) == 0;
  return counted ? pulse : 0;
}

FringeCounter::FringeCounter(Resolution resolution, double hysteresis)
    : pulse_um_(pulse_um(resolution)),
      play_(std::asin(hysteresis / 2) / (2 * std::numbers::pi) *
            pulses_per_fringe(resolution)) {}

std::int64_t FringeCounter::update(double x_um) {
  const double x = x_um / pulse_um_;
  const std::int64_t before = count_;
  const auto whole = static_cast<double>(count_);
  if (x > whole + 1 + play_)
    count_ = static_cast<std::int64_t>(std::floor(x - play_));
  else if (x < whole - play_)
    count_ = static_cast<std::int64_t>(std::floor(x + play_));
  return count_ - before;
}

double FringeCounter::edge_um(std::int64_t count, bool up) const {
  const auto whole = static_cast<double>(count);
  return (up ? whole + play_ : whole + 1 - play_) * pulse_um_;
}

}  // namespace unstep::machine
