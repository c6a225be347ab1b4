#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "steps/timing.h"

/// When the steps of a move come, many at a time.
namespace unstep::steps {

/// The times of `count` steps that share a move's length evenly: gaining
/// speed, at one speed, braking. In each part a time is a root or a product of
/// the step's number, so that neighbours are computed side by side.
class StepTimes {
 public:
  /// `length` in mm; `acceleration` in mm/s^2, 0: no limit; `clock` in ticks a
  /// second. REQUIRES: count >= 1, length > 0, speed.most > 0.
  StepTimes(const MoveSpeed& speed, double length, double acceleration,
            double clock, std::uint64_t count);

  /// Ticks from the start of the move until its last step. Infinite or no
  /// number where the options are that far out.
  [[nodiscard]] double total() const { return total_; }

  /// Ticks from the start of the move until the steps first + 1, ..., first +
  /// out.size(). REQUIRES: these are not more than all, and below 2^31.
  void fill(std::uint64_t first, std::span<double> out) const;

 private:
  std::uint64_t count_;
  std::uint64_t up_ = 0;  ///< the last step that still gains speed
  std::uint64_t down_;    ///< the last step that does not brake
  double square_ = 0;     ///< of a root: what a step adds to its square,
  double first_ = 0;      ///< and the roots at the start and the end, ticks
  double last_ = 0;
  double steady_at_ = 0;  ///< of steps at one speed: the time of step 0,
  double steady_ = 0;     ///< and from step to step
  double total_ = 0;
};

/// Turns the times of steps into whole waits.
class WaitMaker {
 public:
  static constexpr std::size_t kBlock = 512;
  /// Ticks of a move at most.
  static constexpr double kMaxTicks = 1LL << 50;

  /// Waits of the first `out.size()` steps of a move after the one before,
  /// each the difference of times rounded to a tick, and 1 at least. False if
  /// one is 2^32 or more, or the move takes more than kMaxTicks.
  [[nodiscard]] bool make(const StepTimes& times, std::span<std::uint32_t> out);

 private:
  bool make_block(std::span<const double> times, std::span<std::uint32_t> out);
  bool make_late(std::span<const double> times, std::span<std::uint32_t> out);

  /// From the last whole tick of the moves before: when they ended, and the
  /// tick of the last step.
  double begin_ = 0;
  std::int64_t at_ = 0;
};

}  // namespace unstep::steps
