#pragma once

#include <cstdint>

/// The pulse former of "Zenit": from two sinusoids of the laser interferometer,
/// 90 degrees apart, to count pulses with a direction.
namespace unstep::machine {

/// He-Ne laser, rounded as the article rounds: lambda / 8 is 0.08 um.
inline constexpr double kWavelengthUm = 0.64;
/// A fringe passes every lambda / 2 of the carriage's way.
inline constexpr double kFringeUm = kWavelengthUm / 2;
/// The highest frequency of the sinusoids, and the length of a pulse.
inline constexpr double kMaxFringeHz = 3e6;
inline constexpr std::int64_t kPulseNs = 200;

/// The way of one pulse: all four edges of a fringe, or one.
enum class Resolution : std::uint8_t { eighth_wave, half_wave };

[[nodiscard]] constexpr int pulses_per_fringe(Resolution resolution) {
  return resolution == Resolution::eighth_wave ? 4 : 1;
}
[[nodiscard]] constexpr double pulse_um(Resolution resolution) {
  return kFringeUm / pulses_per_fringe(resolution);
}
inline constexpr double kPulseUm = pulse_um(Resolution::eighth_wave);

/// A comparator about 0 that turns on above +h/2 and off below -h/2.
class SchmittTrigger {
 public:
  explicit SchmittTrigger(double hysteresis) : half_(hysteresis / 2) {}
  bool update(double input) {
    if (input > half_) on_ = true;
    if (input < -half_) on_ = false;
    return on_;
  }

 private:
  double half_;
  bool on_ = false;
};

/// The circuit, sample by sample: as fast as the signals are sampled, which
/// must be often enough that less than a quarter of a fringe passes between
/// two samples.
class PulseFormer {
 public:
  /// `hysteresis` in amplitudes of the sinusoids, 0 <= hysteresis < 2.
  PulseFormer(Resolution resolution, double hysteresis);

  /// One sample of sin and cos of 2 pi x / fringe. Returns +1, -1 or 0 pulses.
  /// The first sample only sets the state.
  int update(double sine, double cosine);

  /// Samples where both triggers turned at once: the direction is unknown, two
  /// edges are lost. Noise beyond the hysteresis or too high a speed.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  Resolution resolution_;
  SchmittTrigger sine_;
  SchmittTrigger cosine_;
  int quadrant_ = -1;
  std::uint64_t lost_ = 0;
};

/// The same from positions instead of signals, so any number of fringes a call:
/// pulse n is given where x = n pulses + play upwards and n pulses - play
/// downwards. Equal to PulseFormer where that samples often enough.
class FringeCounter {
 public:
  /// Starts at 0 <= x < 1 pulse.
  FringeCounter(Resolution resolution, double hysteresis);

  /// REQUIRES: |x_um| < 2^52 pulses. Returns the pulses since the last call.
  std::int64_t update(double x_um);

  /// Pulses up minus pulses down since the start.
  [[nodiscard]] std::int64_t count() const { return count_; }

  /// Where the count becomes `count`, going up or down.
  [[nodiscard]] double edge_um(std::int64_t count, bool up) const;

 private:
  double pulse_um_;
  double play_;  ///< pulses
  std::int64_t count_ = 0;
};

}  // namespace unstep::machine
