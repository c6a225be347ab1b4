#pragma once

#include <cstdint>

#include "machine/pulse_former.h"

/// The motor control of "Zenit".
namespace unstep::machine {

/// The control works once per tick: a period of the pulse width modulator.
inline constexpr double kTickSeconds = 125e-6;
inline constexpr std::int64_t kTickNs = 125'000;

/// The clock fx of the rate multiplier and its bits: k = d / 2^10. At lambda/8
/// a step of d is 10 um/s, so 20 um/s .. 1 cm/s are d = 2 .. 1000.
inline constexpr std::uint32_t kRateBits = 10;
inline constexpr std::uint32_t kRateClockHz = 128'000;
inline constexpr std::uint32_t kClocksPerTick = 16;
inline constexpr double kMinSpeedUm = 20;      ///< per second
inline constexpr double kMaxSpeedUm = 10'000;  ///< per second

/// Pulses of a binary rate multiplier (interpolation::RateMultiplier, frame
/// after frame) up to its clock pulse `clocks`, in constant time for n bits.
/// REQUIRES: 1 <= bits <= 31, rate < 2^bits, clocks < 2^32.
[[nodiscard]] std::uint64_t rate_pulses(std::uint32_t rate, std::uint32_t bits,
                                        std::uint64_t clocks);

/// y = N - integral(fu dt) + k integral(fx dt): N are the pulses to go in CR1,
/// fu the pulses of the pulse former, k the rate in CR2, fx the clock. In
/// positioning k is 0, at constant speed N is 0 (our reading of the formula).
/// The duty of the motor is (y - kLead * speed) / range, clamped to +-1, where
/// speed is that of fu, smoothed; the braking term is ours.
class MotorControl {
 public:
  enum class Mode : std::uint8_t { positioning, constant_speed };
  static constexpr double kLeadTicks = 76;
  static constexpr double kRangeUm = 64;
  /// Positioning is done when |y| <= 1 pulse and the speed below 32 um/s.
  static constexpr std::int64_t kDoneError = 1;
  static constexpr double kDoneSpeedUm = 32;

  explicit MotorControl(Resolution resolution = Resolution::eighth_wave);

  void load_way(std::int32_t pulses) { cr1_ = pulses; }
  /// |rate| < 2^10; the sign is the direction.
  void load_rate(std::int32_t rate) { cr2_ = rate; }
  void set_mode(Mode mode) { mode_ = mode; }
  /// Takes over the mode and its register.
  void start();
  void stop() { running_ = false; }

  /// Adds pulses from outside to y.
  void feed(std::int64_t pulses) { y_ += pulses; }

  /// One tick in which the pulse former gave `pulses`. Returns the duty for the
  /// next, -1..1 in steps of 1/1024, 0 if stopped.
  double tick(std::int64_t pulses);

  [[nodiscard]] bool running() const { return running_; }
  /// Positioning reached its end. It goes on holding the place.
  [[nodiscard]] bool done() const;
  /// y after the last tick, in pulses.
  [[nodiscard]] std::int64_t error() const { return y_; }

 private:
  double pulse_um_;
  std::int32_t cr1_ = 0;
  std::int32_t cr2_ = 0;
  Mode mode_ = Mode::positioning;
  Mode active_ = Mode::positioning;
  bool running_ = false;
  std::int64_t y_ = 0;
  std::int32_t rate_ = 0;
  std::uint64_t clocks_ = 0;
  double speed_ = 0;  ///< pulses per tick, smoothed over 8 ticks
};

}  // namespace unstep::machine
