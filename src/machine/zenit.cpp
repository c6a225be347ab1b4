#include "machine/zenit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace unstep::machine {

using enum Operation;

Zenit::Zenit(const Plant& plant, std::uint64_t seed)
    : plant_(plant),
      noise_(seed),
      drives_{Drive{Carriage(plant),
                    FringeCounter(Resolution::eighth_wave, plant.hysteresis),
                    {},
                    MotorControl(Resolution::eighth_wave)},
              Drive{Carriage(plant),
                    FringeCounter(Resolution::eighth_wave, plant.hysteresis),
                    {},
                    MotorControl(Resolution::eighth_wave)}} {}

bool Zenit::write(const WordBytes& bytes) {
  const Result<ControllerWord> word = unpack_word(bytes);
  if (!word) return false;
  const Command* command = decode_command(*word);
  if (command == nullptr || command->operation == Operation::read_counter)
    return false;
  act(*command, command_data(*word));
  return true;
}

std::optional<ReadBytes> Zenit::read(const WordBytes& bytes) {
  const Result<ControllerWord> word = unpack_word(bytes);
  if (!word) return std::nullopt;
  const Command* command = decode_command(*word);
  if (command == nullptr || command->operation != Operation::read_counter)
    return std::nullopt;
  const auto answer = at(command->axis).counter.read(ticks_ * kTickNs);
  if (!answer) return std::nullopt;
  return pack_read(answer->word);
}

void Zenit::reset() {
  for (Drive& drive : drives_) {
    drive.counter.reset();
    set_resolution(drive, Resolution::eighth_wave);
  }
  laser_ = {};
  light_left_.reset();
}

bool Zenit::command(Operation operation, Axis axis, std::uint32_t data) {
  return write(
      pack_word(encode_command(machine::command(operation, axis), data)));
}

std::optional<std::int32_t> Zenit::read_counter(Axis axis) {
  const auto bytes = read(pack_word(
      encode_command(machine::command(Operation::read_counter, axis))));
  if (!bytes) return std::nullopt;
  return from_direct_code(unpack_read(*bytes));
}

void Zenit::act(const Command& command, std::uint32_t data) {
  Drive& drive = at(command.axis);
  switch (command.operation) {
    case eighth_wave: set_resolution(drive, Resolution::eighth_wave); return;
    case half_wave: set_resolution(drive, Resolution::half_wave); return;
    case load_counter: drive.counter.load(data); return;
    case reset_counter: drive.counter.reset(); return;
    default: break;
  }
  if (command.module == Module::motor)
    act_on_motor(drive, command.operation, data);
  else
    act_on_laser(command.operation, data);
}

void Zenit::act_on_motor(Drive& drive, Operation operation,
                         std::uint32_t data) {
  MotorControl& motor = drive.motor;
  switch (operation) {
    case start_motor: motor.start(); break;
    case stop_motor: motor.stop(); break;
    case positioning: motor.set_mode(MotorControl::Mode::positioning); break;
    case constant_speed:
      motor.set_mode(MotorControl::Mode::constant_speed);
      break;
    case reset_cr1: motor.load_way(0); break;
    case reset_cr2: motor.load_rate(0); break;
    case load_cr1: motor.load_way(from_direct_code(data)); break;
    case load_cr2:
      motor.load_rate(
          from_direct_code(data & (0x800000U | ((1U << kRateBits) - 1))));
      break;
    default: break;
  }
}

void Zenit::act_on_laser(Operation operation, std::uint32_t data) {
  switch (operation) {
    case pulse_mode: laser_.set_mode(LaserModulator::Mode::pulse); break;
    case level_mode: laser_.set_mode(LaserModulator::Mode::level); break;
    case laser_on: laser_.switch_on(true); break;
    case laser_off: laser_.switch_on(false); break;
    case reset_cr: laser_.reset_way(); break;
    case load_dr1: laser_.load_dr1(data); break;
    case load_dr2: laser_.load_dr2(data); break;
    default: break;
  }
}

void Zenit::set_resolution(Drive& drive, Resolution resolution) {
  drive.resolution = resolution;
  drive.motor = MotorControl(resolution);
  drive.fringes = FringeCounter(resolution, plant_.hysteresis);
  drive.fringes.update(drive.carriage.position_um());
  drive.duty = 0;
}

void Zenit::tick_drive(Drive& drive) {
  drive.carriage.tick(drive.duty, noise_);
  // Noise on the sinusoids shifts where they cross the thresholds.
  const double jitter =
      plant_.fringe_noise * noise_.next() * kFringeUm / (2 * std::numbers::pi);
  drive.pulses = drive.fringes.update(drive.carriage.position_um() + jitter);
  drive.counter.add(drive.pulses, ticks_ * kTickNs);
  drive.duty = drive.motor.tick(drive.pulses);
  top_speed_um_ = std::max(top_speed_um_, std::abs(drive.carriage.speed_um()));
}

void Zenit::tick_laser(double x_before, double y_before) {
  const Drive& x = drives_[0];
  const double x_now = x.carriage.position_um();
  const double dx = x_now - x_before;
  const double dy = drives_[1].carriage.position_um() - y_before;
  double begins = 0;  // as a share of the tick
  const std::int64_t at_pulse = laser_.move(x.pulses, ticks_ * kTickNs);
  if (at_pulse != 0) {
    const std::int64_t count = x.fringes.count() - x.pulses + at_pulse;
    const double edge = x.fringes.edge_um(count, at_pulse > 0);
    begins = dx == 0 ? 0 : std::clamp((edge - x_before) / dx, 0.0, 1.0);
    Flash flash;
    flash.x0_um = x_before + begins * dx + plant_.head_noise_um * noise_.next();
    flash.y0_um = y_before + begins * dy + plant_.head_noise_um * noise_.next();
    // The shake stays through the flash.
    flash.x1_um = flash.x0_um;
    flash.y1_um = flash.y0_um;
    flashes_.push_back(flash);
    light_left_ = laser_.width_us() * 1e-6;
  }
  if (!light_left_) return;
  const double lit = std::min(*light_left_, (1 - begins) * kTickSeconds);
  flashes_.back().x1_um += lit / kTickSeconds * dx;
  flashes_.back().y1_um += lit / kTickSeconds * dy;
  *light_left_ -= lit;
  if (*light_left_ <= 0) light_left_.reset();
}

bool Zenit::saturated() const {
  return std::ranges::any_of(
      drives_, [](const Drive& drive) { return std::abs(drive.duty) >= 1; });
}

void Zenit::tick() {
  ++ticks_;
  const double x = drives_[0].carriage.position_um();
  const double y = drives_[1].carriage.position_um();
  for (Drive& drive : drives_) tick_drive(drive);
  tick_laser(x, y);
}

}  // namespace unstep::machine
