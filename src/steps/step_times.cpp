#include "steps/step_times.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace unstep::steps {
namespace {

/// A double this large, plus one below 2^50 of either sign, has the sum's
/// nearest integer in its low bits.
constexpr double kWhole = 6755399441055744.0;  // 3 * 2^51

std::uint64_t rounded_bits(double time) {
  return std::bit_cast<std::uint64_t>(time + kWhole);
}

std::int64_t rounded(double time) {
  return static_cast<std::int64_t>(rounded_bits(time) - rounded_bits(0));
}

/// Steps whose end is within `share` of all.
std::uint64_t steps_within(double share, std::uint64_t count) {
  const auto all = static_cast<double>(count);
  return static_cast<std::uint64_t>(
      std::clamp(std::floor(share * all), 0.0, all));
}

}  // namespace

StepTimes::StepTimes(const MoveSpeed& speed, double length, double acceleration,
                     double clock, std::uint64_t count)
    : count_(count), down_(count) {
  const double a = acceleration;
  const auto all = static_cast<double>(count);
  const double step = length / all;
  if (a <= 0) {
    steady_ = step / speed.most * clock;
    total_ = steady_ * all;
    return;
  }
  const double v0 = speed.first * speed.first;
  const double v1 = speed.last * speed.last;
  // Where gaining speed would meet braking.
  const double peak =
      std::min(speed.most, std::sqrt((v0 + v1) / 2 + a * length));
  const double gaining = std::max(0.0, (peak * peak - v0) / (2 * a));
  const double braking = std::max(0.0, (peak * peak - v1) / (2 * a));
  up_ = steps_within(gaining / length, count);
  down_ = std::max(up_, steps_within(1 - braking / length, count));
  // v = sqrt(v0^2 + 2 a s), and the time is (v - v0) / a.
  const double ticks = clock / a;
  square_ = 2 * a * step * ticks * ticks;
  first_ = speed.first * ticks;
  last_ = speed.last * ticks;
  steady_ = step / peak * clock;
  const double gained = (peak - speed.first) * ticks;
  steady_at_ = gained - gaining / peak * clock;
  const double steady = std::max(0.0, length - gaining - braking);
  total_ = gained + steady / peak * clock + (peak - speed.last) * ticks;
}

// The numbers are locals so that they stay in registers: members might change
// with every value that is written.
void StepTimes::fill(std::uint64_t first, std::span<double> out) const {
  // Step k of `out` is step first + 1 + k of the move.
  const auto number = [from = static_cast<double>(first + 1)](std::int32_t k) {
    return from + static_cast<double>(k);
  };
  const auto until = [&out, first](std::uint64_t last) {
    return static_cast<std::int32_t>(
        std::min<std::uint64_t>(last - std::min(first, last), out.size()));
  };
  double* const to = out.data();
  const double square = square_;
  const double v0 = first_;
  const double v0_square = v0 * v0;
  const std::int32_t up = until(up_);
  for (std::int32_t k = 0; k < up; ++k) {
    to[k] = std::sqrt(v0_square + square * number(k)) - v0;
  }
  const double at = steady_at_;
  const double wait = steady_;
  const std::int32_t down = until(down_);
  for (std::int32_t k = up; k < down; ++k) to[k] = at + wait * number(k);
  const double v1 = last_;
  const double v1_square = v1 * v1;
  const double total = total_ + v1;
  const double all = static_cast<double>(count_);
  const auto size = static_cast<std::int32_t>(out.size());
  for (std::int32_t k = down; k < size; ++k) {
    to[k] = total - std::sqrt(v1_square + square * (all - number(k)));
  }
}

bool WaitMaker::make(const StepTimes& times, std::span<std::uint32_t> out) {
  if (!(begin_ + times.total() < kMaxTicks)) return false;
  std::array<double, kBlock> block;
  for (std::size_t done = 0; done < out.size(); done += kBlock) {
    const std::size_t count = std::min(kBlock, out.size() - done);
    const std::span now = std::span(block).first(count);
    times.fill(done, now);
    if (!make_block(now, out.subspan(done, count)) &&
        !make_late(now, out.subspan(done, count)))
      return false;
  }
  // Numbers that stay small keep their precision.
  const double end = begin_ + times.total();
  const std::int64_t whole = rounded(end);
  begin_ = end - static_cast<double>(whole);
  at_ -= whole;
  return true;
}

/// False, and nothing has changed, if a wait is not 1 to 2^32 - 1.
bool WaitMaker::make_block(std::span<const double> times,
                           std::span<std::uint32_t> out) {
  std::array<std::uint64_t, kBlock + 1> ticks;
  ticks[0] = rounded_bits(0) + static_cast<std::uint64_t>(at_);
  const double begin = begin_;
  for (std::size_t i = 0; i < times.size(); ++i) {
    ticks[i + 1] = rounded_bits(begin + times[i]);
  }
  std::uint64_t all = 0;
  std::uint32_t* to = out.data();
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::uint64_t wait = ticks[i + 1] - ticks[i];
    all |= wait | (wait - 1);
    to[i] = static_cast<std::uint32_t>(wait);
  }
  if (all >> 32 != 0) return false;
  at_ = static_cast<std::int64_t>(ticks[times.size()] - rounded_bits(0));
  return true;
}

/// Step by step, where steps are too near to each other.
bool WaitMaker::make_late(std::span<const double> times,
                          std::span<std::uint32_t> out) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::int64_t tick = std::max(at_ + 1, rounded(begin_ + times[i]));
    const std::int64_t wait = tick - at_;
    if (wait >> 32 != 0) return false;
    out[i] = static_cast<std::uint32_t>(wait);
    at_ = tick;
  }
  return true;
}

}  // namespace unstep::steps
