#include "machine/zenit_commands.h"

#include <algorithm>
#include <array>

namespace unstep::machine {
namespace {

using enum Module;
using enum Operation;

// As printed, in octal.
constexpr std::array kCommands{
    Command{pulse_former, Axis::x, 02015, eighth_wave, "lambda/8", true},
    Command{pulse_former, Axis::x, 02025, half_wave, "lambda/2", true},
    Command{pulse_former, Axis::y, 02115, eighth_wave, "lambda/8", true},
    Command{pulse_former, Axis::y, 02125, half_wave, "lambda/2", true},
    Command{counter, Axis::x, 02005, load_counter, "load", true},
    Command{counter, Axis::x, 00005, reset_counter, "reset", true},
    Command{counter, Axis::x, 06405, read_counter, "read", true},
    Command{counter, Axis::y, 02105, load_counter, "load", true},
    Command{counter, Axis::y, 00105, reset_counter, "reset", true},
    Command{counter, Axis::y, 06505, read_counter, "read", true},
    Command{motor, Axis::x, 00105, start_motor, "start", true},
    Command{motor, Axis::x, 00005, stop_motor, "stop", true},
    Command{motor, Axis::x, 00115, positioning, "positioning", true},
    Command{motor, Axis::x, 02115, constant_speed, "constant speed", true},
    Command{motor, Axis::x, 00205, reset_cr1, "reset CR1", true},
    Command{motor, Axis::x, 00215, reset_cr2, "reset CR2", true},
    Command{motor, Axis::x, 02205, load_cr1, "load CR1", true},
    Command{motor, Axis::x, 02215, load_cr2, "load CR2", true},
    Command{motor, Axis::y, 00105, start_motor, "start", false},
    Command{motor, Axis::y, 00005, stop_motor, "stop", false},
    Command{motor, Axis::y, 00215, positioning, "positioning", true},
    Command{motor, Axis::y, 02215, constant_speed, "constant speed", true},
    Command{motor, Axis::y, 00305, reset_cr1, "reset CR1", true},
    Command{motor, Axis::y, 00315, reset_cr2, "reset CR2", true},
    Command{motor, Axis::y, 02305, load_cr1, "load CR1", true},
    Command{motor, Axis::y, 02315, load_cr2, "load CR2", true},
    Command{laser, Axis::x, 02765, pulse_mode, "pulse mode", true},
    Command{laser, Axis::x, 00765, level_mode, "level mode", true},
    Command{laser, Axis::x, 02445, laser_on, "on", true},
    Command{laser, Axis::x, 00445, laser_off, "off", true},
    Command{laser, Axis::x, 00775, reset_cr, "reset CR", true},
    Command{laser, Axis::x, 02745, load_dr1, "load DR1", true},
    Command{laser, Axis::x, 02775, load_dr2, "load DR2", true},
};

}  // namespace

std::span<const Command> commands() { return kCommands; }

const Command* find_command(Module module, Axis axis, std::uint16_t code) {
  const auto* found = std::ranges::find_if(kCommands, [&](const Command& c) {
    return c.module == module && c.axis == axis && c.code == code;
  });
  return found == kCommands.end() ? nullptr : found;
}

const Command& command(Operation operation, Axis axis) {
  return *std::ranges::find_if(kCommands, [&](const Command& c) {
    return c.operation == operation && c.axis == axis;
  });
}

}  // namespace unstep::machine
