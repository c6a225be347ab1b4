#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

/// Table 2 of "Zenit", the codes of its programmable modules.
namespace unstep::machine {

enum class Module : std::uint8_t { pulse_former, counter, motor, laser };
enum class Axis : std::uint8_t { x, y };

enum class Operation : std::uint8_t {
  eighth_wave,     ///< pulse former: a pulse per lambda / 8
  half_wave,       ///< pulse former: a pulse per lambda / 2
  load_counter,    ///< data: 24 bits, sign and magnitude
  reset_counter,   ///<
  read_counter,    ///< answers 24 bits, sign and magnitude
  start_motor,     ///<
  stop_motor,      ///< no current: the carriage coasts
  positioning,     ///< the next start goes the way in CR1, and holds
  constant_speed,  ///< the next start runs at the rate in CR2
  reset_cr1,       ///<
  reset_cr2,       ///<
  load_cr1,        ///< data: pulses to go, sign and magnitude
  load_cr2,        ///< data: rate of the multiplier, sign and 10 bits
  pulse_mode,      ///< laser: a pulse whenever DR2 pulses were counted
  level_mode,      ///< laser: the level in DR1 is held
  laser_on,        ///<
  laser_off,       ///<
  reset_cr,        ///< laser: the counter of the way since the last pulse
  load_dr1,        ///< data: width of a pulse in us, or the level in mV
  load_dr2,        ///< data: pulses of x from dot to dot
};

/// A line of the table. Codes clash: 0105 starts motor x and resets counter y,
/// 0215 is two things inside the motor. The key is (module, axis, code).
struct Command {
  Module module;
  Axis axis;  ///< x for the laser
  std::uint16_t code;
  Operation operation;
  std::string_view name;
  bool printed;  ///< false: the table gives no code; ours is that of x
};

[[nodiscard]] std::span<const Command> commands();
[[nodiscard]] const Command* find_command(Module module, Axis axis,
                                          std::uint16_t code);
/// REQUIRES: the module has the operation.
[[nodiscard]] const Command& command(Operation operation, Axis axis = Axis::x);

}  // namespace unstep::machine
