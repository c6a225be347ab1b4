#include "machine/reversible_counter.h"

#include <algorithm>

#include "machine/controller_word.h"
#include "machine/pulse_former.h"

namespace unstep::machine {

void ReversibleCounter::reset() { load(0); }

void ReversibleCounter::load(std::uint32_t word) {
  magnitude_ = word & kMaxMagnitude;
  negative_ = magnitude_ != 0 && word > kMaxMagnitude;
  overflowed_ = false;
}

void ReversibleCounter::step(bool up) {
  if (magnitude_ == 0) negative_ = !up;
  if (up != negative_) {
    if (magnitude_ == kMaxMagnitude) overflowed_ = true;
    magnitude_ = (magnitude_ + 1) & kMaxMagnitude;
  } else {
    --magnitude_;
  }
  if (magnitude_ == 0) negative_ = false;
}

bool ReversibleCounter::pulse(bool up, std::int64_t now_ns) {
  if (last_pulse_ns_ && now_ns - *last_pulse_ns_ < kPulseNs) {
    ++lost_;
    return false;
  }
  last_pulse_ns_ = now_ns;
  step(up);
  return true;
}

void ReversibleCounter::add(std::int64_t pulses, std::int64_t now_ns) {
  if (pulses == 0) return;
  last_pulse_ns_ = now_ns - kPulseNs;
  const std::int64_t next = value() + pulses;
  if (next <= kMaxMagnitude && next >= -std::int64_t{kMaxMagnitude}) {
    magnitude_ = static_cast<std::uint32_t>(next < 0 ? -next : next);
    negative_ = next < 0;
    return;
  }
  for (std::int64_t i = 0; i < (pulses < 0 ? -pulses : pulses); ++i)
    step(pulses > 0);
}

std::optional<ReversibleCounter::Read> ReversibleCounter::read(
    std::int64_t now_ns) {
  if (last_read_ns_ && now_ns - *last_read_ns_ < kReadPeriodNs)
    return std::nullopt;
  last_read_ns_ = now_ns;
  Read answer{word(), now_ns};
  if (last_pulse_ns_)
    answer.ready_ns = std::max(now_ns, *last_pulse_ns_ + kPulseNs);
  return answer;
}

std::uint32_t ReversibleCounter::word() const {
  return to_direct_code(value());
}

std::int32_t ReversibleCounter::value() const {
  const auto magnitude = static_cast<std::int32_t>(magnitude_);
  return negative_ ? -magnitude : magnitude;
}

}  // namespace unstep::machine
