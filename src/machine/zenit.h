#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "machine/carriage.h"
#include "machine/controller_word.h"
#include "machine/laser_modulator.h"
#include "machine/motor_control.h"
#include "machine/pulse_former.h"
#include "machine/reversible_counter.h"

/// The photogrammetric automaton "Zenit": a carriage on two axes under a laser,
/// run by words from a computer, in simulated time.
namespace unstep::machine {

/// A flash: where the light was when it began and when it ended.
struct Flash {
  double x0_um = 0;
  double y0_um = 0;
  double x1_um = 0;
  double y1_um = 0;
};

/// Time passes in tick() only; everything is deterministic for a seed.
///
///     Zenit zenit(Plant{}, 1);
///     zenit.command(Operation::load_cr1, Axis::x, to_direct_code(12500));
///     zenit.command(Operation::positioning, Axis::x);
///     zenit.command(Operation::start_motor, Axis::x);
///     while (!zenit.motor_done(Axis::x)) zenit.tick();
class Zenit {
 public:
  Zenit(const Plant& plant, std::uint64_t seed);

  /// A word to a module. X1, the answer to a word that acts or writes, says
  /// true; a word with an unknown command, a read or a broken strobe, false.
  bool write(const WordBytes& bytes);
  /// A word that reads. The three bytes with X2; nothing if it is no read, or
  /// comes within 100 us of the last one of that counter.
  std::optional<ReadBytes> read(const WordBytes& bytes);
  /// Z, general reset: registers, counters, motors off, laser off. The
  /// carriage and the time go on.
  void reset();

  /// The same by name. REQUIRES: data < 2^24.
  bool command(Operation operation, Axis axis = Axis::x,
               std::uint32_t data = 0);
  std::optional<std::int32_t> read_counter(Axis axis);

  /// Pulses of an interpolator outside, in place of the rate multiplier's; for
  /// a motor at constant speed. Our addition: the table has no code for it.
  void feed(Axis axis, std::int64_t pulses) { at(axis).motor.feed(pulses); }

  void tick();

  /// An interrupt line of ours; the table has no code that asks for it.
  [[nodiscard]] bool motor_done(Axis axis) const {
    return at(axis).motor.done();
  }
  [[nodiscard]] double seconds() const {
    return static_cast<double>(ticks_) * kTickSeconds;
  }
  [[nodiscard]] double position_um(Axis axis) const {
    return at(axis).carriage.position_um();
  }
  [[nodiscard]] double speed_um(Axis axis) const {
    return at(axis).carriage.speed_um();
  }
  [[nodiscard]] std::int64_t motor_error(Axis axis) const {
    return at(axis).motor.error();
  }
  /// Pulses of the pulse former in the last tick.
  [[nodiscard]] std::int64_t pulses(Axis axis) const { return at(axis).pulses; }
  /// A motor is at full duty.
  [[nodiscard]] bool saturated() const;
  [[nodiscard]] double top_speed_um() const { return top_speed_um_; }
  [[nodiscard]] const LaserModulator& laser() const { return laser_; }
  [[nodiscard]] const std::vector<Flash>& flashes() const { return flashes_; }

 private:
  struct Drive {
    Carriage carriage;
    FringeCounter fringes;
    ReversibleCounter counter;
    MotorControl motor;
    Resolution resolution = Resolution::eighth_wave;
    double duty = 0;
    std::int64_t pulses = 0;  ///< of the last tick
  };

  Drive& at(Axis axis) { return drives_[axis == Axis::y]; }
  [[nodiscard]] const Drive& at(Axis axis) const {
    return drives_[axis == Axis::y];
  }
  void act(const Command& command, std::uint32_t data);
  void act_on_motor(Drive& drive, Operation operation, std::uint32_t data);
  void act_on_laser(Operation operation, std::uint32_t data);
  void set_resolution(Drive& drive, Resolution resolution);
  void tick_drive(Drive& drive);
  void tick_laser(double x_before, double y_before);

  Plant plant_;
  Noise noise_;
  std::array<Drive, 2> drives_;
  LaserModulator laser_;
  std::vector<Flash> flashes_;
  std::optional<double> light_left_;  ///< seconds of the flash under way
  std::int64_t ticks_ = 0;
  double top_speed_um_ = 0;
};

}  // namespace unstep::machine
