#pragma once

#include <cstdint>

/// The plant that the control of "Zenit" moves. The article gives none of it:
/// every constant here is ours.
namespace unstep::machine {

/// A carriage on air bearings with a DC motor.
struct Plant {
  double mass_kg = 4;
  /// Viscous drag with the back-EMF of the motor, N s/m.
  double drag = 400;
  /// At full duty; force / drag is the top speed, 1 cm/s.
  double force_n = 4;
  double dry_friction_n = 0.002;  ///< of cables and bellows
  /// Random force, rms, white at the rate of the ticks (8 kHz).
  double force_noise_n = 0.02;
  /// Noise of the interferometer's sinusoids, rms, in amplitudes.
  double fringe_noise = 0.02;
  /// Shake of the optical head against the carriage per flash and axis, rms,
  /// um. The interferometer does not see it.
  double head_noise_um = 0.1;
  double hysteresis = 0.2;  ///< of the Schmitt triggers, in amplitudes

  /// The same with every noise `factor` times as large.
  [[nodiscard]] Plant noisier(double factor) const;
};

/// Numbers near the normal distribution, variance 1, within +-4.9, the same on
/// every platform for a seed: eight uniform 16-bit numbers of SplitMix64,
/// added.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(seed) {}
  double next();

 private:
  std::uint64_t bits();
  std::uint64_t state_;
};

/// One axis, in ticks, by the semi-implicit Euler method: the time constant of
/// the plant, 10 ms, is 80 ticks.
class Carriage {
 public:
  explicit Carriage(const Plant& plant) : plant_(plant) {}

  /// Force duty * force_n and a random force over one tick.
  void tick(double duty, Noise& noise);

  [[nodiscard]] double position_um() const { return position_um_; }
  [[nodiscard]] double speed_um() const { return speed_um_; }  ///< per second

 private:
  Plant plant_;
  double position_um_ = 0;
  double speed_um_ = 0;
};

}  // namespace unstep::machine
